#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/range.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::base {

/// What a parameter may hold.
enum class Type { flag, integer, number, word };

/// One parameter, described once: the command line, case files, both directions of JSON and the
/// check of its range come from this.
struct Parameter {
  std::string name;  ///< in files: "restitution", "wall_density"
  std::string help;  ///< one or two phrases, for --help
  std::string placeholder = "X";
  /// On the command line, without dashes: "wall-density"; empty where it is not offered there.
  std::string flag = {};
  /// In formulas, as plain text and as typeset: "mu", "μ".
  std::string symbol = {}, typeset = {};
  Type type = Type::number;
  bool may_be_automatic = false;
  std::vector<std::string> choices = {};  ///< of a word; any word when empty
  std::optional<Range> range = {};
  std::optional<Value> fallback = {};  ///< of a file that does not name it
  bool silent = false;                 ///< not named where it has its fallback
  /// Of a word that is long: what people are shown in its place.
  std::function<std::string(const std::string& word)> shown = {};

  std::function<Value(const void* owner)> get = {};
  std::function<void(void* owner, const Value& value)> set = {};

  /// After "must be": "an integer", "one of map, delta".
  std::string allowed() const;

  /// The value if it is of the type that the parameter takes (a whole number is a number too);
  /// nothing if it is not. The range is not looked at.
  std::optional<Value> accepted(const Value& value) const;

  /// The value that a text stands for; "auto" is nothing where the parameter may be automatic.
  /// @return nothing when it stands for none
  std::optional<Value> parsed(std::string_view text) const;

  /// Whether the value is in the range; automatic is.
  bool in_range(const Value& value) const;
};

/// The value that a text stands for; the range is not looked at.
/// @param label how messages name it: "--order", "system.cubic ="
/// @throws InputError LABEL 'text' (what is allowed)
Value value_from(const Parameter& parameter, std::string_view text, const std::string& label);

}  // namespace fpkcheck::base
