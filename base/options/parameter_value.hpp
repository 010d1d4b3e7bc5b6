#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fpkcheck::base {

/// The value of a parameter; std::monostate represents an automatic or absent value.
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

/// Returns the text of a parameter's value for messages and tables: a number with all digits, a
/// word in quotes, or "automatic" for an unset value.
std::string value_as_text(const Value& value);

struct AdmissibleRange {
  std::function<bool(double)> contains;
  std::string requirement;  ///< text after "must be" in messages, such as "a positive number"

  /// Returns a copy of this admissible range with a reason appended to the text `requirement`.
  AdmissibleRange with_reason_in_message(const std::string& reason) const {
    return {contains, requirement + ": " + reason};
  }
};

AdmissibleRange finite_numbers();
AdmissibleRange positive_numbers();
AdmissibleRange non_negative_numbers();
AdmissibleRange closed_interval(double least, double greatest);
AdmissibleRange open_interval(double least, double greatest);
AdmissibleRange even_integers_between(int least, int greatest);

enum class ParameterType { flag, integer, number, word, number_or_formula };

/// The value of a parameter that is a number or the text of a formula.
struct NumberOrFormula {
  std::variant<double, std::string> held;

  NumberOrFormula(double number = 0) : held(number) {}
  NumberOrFormula(std::string formula) : held(std::move(formula)) {}
  bool operator==(const NumberOrFormula&) const = default;

  const double* number() const { return std::get_if<double>(&held); }
  /// Returns the formula. @pre !number()
  const std::string& formula() const { return std::get<std::string>(held); }
};

/// Description of one parameter of the program, from which the command-line option, the key in case
/// files, the JSON value and the range check are derived.
struct Parameter {
  std::string name;  ///< name in files: "restitution", "wall_density"
  std::string help;
  std::string placeholder = "X";
  /// Command-line flag without leading dashes, such as "wall-density"; empty for a parameter
  /// without a flag.
  std::string flag = {};
  /// Symbol of the parameter in formulas as plain text and in typeset form: "mu" and "μ".
  std::string symbol = {}, typeset = {};
  ParameterType type = ParameterType::number;
  bool can_be_automatic = false;
  std::vector<std::string> choices = {};  ///< allowed words; if empty, any word is allowed
  std::optional<AdmissibleRange> range = {};
  std::optional<Value> default_value = {};  ///< value of the parameter if a file lacks its key
  bool omit_default = false;
  /// Optional function that abbreviates a long word for display.
  std::function<std::string(const std::string& word)> display_text = {};

  std::function<Value(const void* owner)> get = {};
  std::function<void(void* owner, const Value& value)> set = {};

  /// Returns the text after "must be" in error messages about the parameter, e.g. "an integer".
  std::string requirement_text() const;

  /// Converts a value to the type of the parameter, such as an integer to a floating-point number;
  /// returns nullopt if the conversion is impossible. The range of the value is not checked.
  std::optional<Value> convert_to_parameter_type(const Value& value) const;

  /// Parses the text of a parameter's value. The text "auto" gives an unset value if the parameter
  /// can be automatic.
  /// @return nullopt if the text is not a value of the parameter's type
  std::optional<Value> parse(std::string_view text) const;

  /// Returns whether a value is in the range of the parameter; true for an unset value.
  bool is_in_range(const Value& value) const;
};

/// Parses the text of a parameter's value without a check of the range.
/// @param label name of the parameter in error messages: "--order", "system.cubic ="
/// @throws InputError "LABEL 'text' (must be ..)" if the text is not a value of the parameter's
/// type
Value parse_value(const Parameter& parameter, std::string_view text, const std::string& label);

}  // namespace fpkcheck::base
