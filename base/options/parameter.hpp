#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/range.hpp"
#include "base/options/value.hpp"

namespace fpkcheck::base {

/// Type of a parameter's value.
enum class Type { flag, integer, number, word };

/// The description of one parameter. Command line, case files, JSON in both directions and range
/// checks are derived from it.
struct Parameter {
  std::string name;  ///< in files: "restitution", "wall_density"
  std::string help;  ///< one or two phrases, for --help
  std::string placeholder = "X";
  /// Command-line flag without the leading dashes: "wall-density"; empty when there is no flag.
  std::string flag = {};
  /// Symbol in formulas, as plain text and typeset: "mu", "μ".
  std::string symbol = {}, typeset = {};
  Type type = Type::number;
  bool can_be_automatic = false;
  std::vector<std::string> choices = {};  ///< choices of a word; when empty, any word
  std::optional<Range> range = {};
  std::optional<Value> default_value = {};  ///< value where a file lacks the key
  bool omit_default = false;                ///< files omit the default value
  /// Returns a short display text for a long word.
  std::function<std::string(const std::string& word)> display_text = {};

  std::function<Value(const void* owner)> get = {};
  std::function<void(void* owner, const Value& value)> set = {};

  /// The text after "must be" in messages: "an integer", "one of map, delta".
  std::string requirement() const;

  /// The value, converted to the parameter's type (an integer converts to a number); nothing when
  /// the type does not match. The range is not checked.
  std::optional<Value> converted_value(const Value& value) const;

  /// Parses a text. Where the parameter may be automatic, "auto" gives an unset value.
  /// @return nothing when the text is not a value of the parameter's type
  std::optional<Value> parse(std::string_view text) const;

  /// Whether the value is in the range; true for an automatic (unset) value.
  bool is_in_range(const Value& value) const;
};

/// Parses a text; the range is not checked.
/// @param label name of the parameter in messages: "--order", "system.cubic ="
/// @throws InputError "LABEL 'text' (must be ..)"
Value parse_value(const Parameter& parameter, std::string_view text, const std::string& label);

}  // namespace fpkcheck::base
