#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace fpkcheck::base {

/// The value of a parameter. std::monostate represents an automatic or absent value.
using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

struct NamedParameterValue {
  std::string name;
  Value value;

  bool operator==(const NamedParameterValue&) const = default;
};
using Values = std::vector<NamedParameterValue>;

inline bool contains(const Values& values, std::string_view name) {
  return std::ranges::find(values, name, &NamedParameterValue::name) != values.end();
}

inline bool is_unset(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// The text of a value for messages and tables. A number has all the digits that are needed to read
/// back the same number, a word is in quotes, and an unset value is "automatic".
std::string text_of(const Value& value);

/// The set of admissible values of a numerical parameter.
struct AdmissibleRange {
  std::function<bool(double)> contains;
  std::string requirement;  ///< text that follows "must be": "a positive number"

  /// The same set of values, with a reason appended to the requirement: "a positive number: without
  /// damping ..."
  AdmissibleRange with_appended_reason(const std::string& reason) const {
    return {contains, requirement + ": " + reason};
  }
};

/// The range of all finite numbers.
AdmissibleRange finite_numbers();
AdmissibleRange positive_numbers();
AdmissibleRange non_negative_numbers();
AdmissibleRange closed_interval(double least, double greatest);  ///< closed interval
AdmissibleRange open_interval(double least, double greatest);    ///< open interval
AdmissibleRange even_integers_between(int least,
                                      int greatest);  ///< even integers from least to greatest

/// Type of a parameter's value.
enum class Type { flag, integer, number, word };

/// The description of one parameter of the program. The command-line option, the key of case files,
/// reading and writing as JSON, and the range check are derived from this description.
struct Parameter {
  std::string name;  ///< name in files: "restitution", "wall_density"
  std::string help;  ///< help text for --help, one or two phrases
  std::string placeholder = "X";
  /// Command-line flag without the leading dashes: "wall-density". Empty if the parameter has no
  /// flag.
  std::string flag = {};
  /// Symbol of the parameter in formulas, as plain text and typeset: "mu", "μ".
  std::string symbol = {}, typeset = {};
  Type type = Type::number;
  bool can_be_automatic = false;
  std::vector<std::string> choices = {};  ///< allowed words; if empty, any word is allowed
  std::optional<AdmissibleRange> range = {};
  std::optional<Value> default_value = {};  ///< value of the parameter if a file lacks its key
  bool omit_default = false;                ///< whether files omit the parameter at its default
  /// Function that returns a short display text for a long word; may be empty.
  std::function<std::string(const std::string& word)> display_text = {};

  std::function<Value(const void* owner)> get = {};
  std::function<void(void* owner, const Value& value)> set = {};

  /// The text that follows "must be" in error messages: "an integer", "one of map, delta".
  std::string requirement_text() const;

  /// Converts a value to the type of the parameter; an integer converts to a number. Returns
  /// nothing if the types do not match. The range is not checked.
  std::optional<Value> convert_to_parameter_type(const Value& value) const;

  /// Parses the text of a value. For a parameter with can_be_automatic, "auto" gives an unset
  /// value.
  /// @return the value, or nothing if the text is not a value of the parameter's type
  std::optional<Value> parse(std::string_view text) const;

  /// Whether a value is in the range of the parameter. An automatic (unset) value is in range.
  bool is_in_range(const Value& value) const;
};

/// Parses the text of a parameter's value. The range is not checked.
/// @param label name of the parameter in messages: "--order", "system.cubic ="
/// @throws InputError "LABEL 'text' (must be ..)" if the text is not a value of the parameter's
/// type
Value parse_value(const Parameter& parameter, std::string_view text, const std::string& label);

}  // namespace fpkcheck::base
