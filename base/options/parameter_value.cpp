#include "base/options/parameter_value.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/input_error.hpp"
#include "base/text/parse_number.hpp"
#include "base/text/printable_text.hpp"

namespace fpkcheck::base {
namespace {

template <class Number>
std::optional<Value> parse_signed_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return parse_number<Number>(text);
}

std::string type_text(const Parameter& parameter) {
  switch (parameter.type) {
    case ParameterType::flag:
      return "true or false";
    case ParameterType::integer:
      return "an integer";
    case ParameterType::number:
      return "a number";
    case ParameterType::word:
      return parameter.choices.empty()
                 ? std::string("a text")
                 : fmt::format("one of {}", fmt::join(parameter.choices, ", "));
    case ParameterType::number_or_formula:
      return "a number or a formula";
  }
  return "";
}

std::string rejection_reason(const Parameter& parameter, std::string_view text) {
  if (parameter.type == ParameterType::number || parameter.type == ParameterType::integer) {
    double ignored = 0;
    const auto error = std::from_chars(text.data(), text.data() + text.size(), ignored).ec;
    if (error == std::errc::result_out_of_range) return "out of the range of double precision";
    return parameter.type == ParameterType::number ? "not a number" : "not an integer";
  }
  return fmt::format("must be {}", parameter.requirement_text());
}

std::string held_text(std::monostate) { return "automatic"; }
std::string held_text(bool value) { return value ? "true" : "false"; }
std::string held_text(std::int64_t value) { return fmt::format("{}", value); }
std::string held_text(double value) { return fmt::format("{}", value); }
std::string held_text(const std::string& value) { return in_quotes(value); }

}  // namespace

std::string Parameter::requirement_text() const {
  return range ? range->requirement : type_text(*this);
}

std::optional<Value> Parameter::convert_to_parameter_type(const Value& value) const {
  if (is_unset(value)) return can_be_automatic ? std::optional(value) : std::nullopt;
  switch (type) {
    case ParameterType::flag:
      return std::holds_alternative<bool>(value) ? std::optional(value) : std::nullopt;
    case ParameterType::integer:
      return std::holds_alternative<std::int64_t>(value) ? std::optional(value) : std::nullopt;
    case ParameterType::number:
      if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
      return std::holds_alternative<double>(value) ? std::optional(value) : std::nullopt;
    case ParameterType::word: {
      const auto* word = std::get_if<std::string>(&value);
      const bool known = word != nullptr &&
                         (choices.empty() || std::ranges::find(choices, *word) != choices.end());
      return known ? std::optional(value) : std::nullopt;
    }
    case ParameterType::number_or_formula:
      if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
      return std::holds_alternative<double>(value) || std::holds_alternative<std::string>(value)
                 ? std::optional(value)
                 : std::nullopt;
  }
  return std::nullopt;
}

std::optional<Value> Parameter::parse(std::string_view text) const {
  if (can_be_automatic && text == "auto") return Value();
  switch (type) {
    case ParameterType::flag:
      if (text == "true" || text == "false") return text == "true";
      return std::nullopt;
    case ParameterType::integer:
      return parse_signed_number<std::int64_t>(text);
    case ParameterType::number:
      return parse_signed_number<double>(text);
    case ParameterType::word:
      return convert_to_parameter_type(std::string(text));
    case ParameterType::number_or_formula:
      return parse_signed_number<double>(text).value_or(std::string(text));
  }
  return std::nullopt;
}

bool Parameter::is_in_range(const Value& value) const {
  if (!range) return true;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    return range->contains(static_cast<double>(*whole));
  }
  const auto* number = std::get_if<double>(&value);
  return number == nullptr || range->contains(*number);
}

Value parse_value(const Parameter& parameter, std::string_view text, const std::string& label) {
  if (const auto value = parameter.parse(text)) return *value;
  throw InputError(
      fmt::format("{} {} ({})", label, in_quotes(text), rejection_reason(parameter, text)));
}

std::string value_as_text(const Value& value) {
  return std::visit([](const auto& held) { return held_text(held); }, value);
}

AdmissibleRange finite_numbers() {
  return {[](double x) { return std::isfinite(x); }, "a finite number"};
}

AdmissibleRange positive_numbers() {
  return {[](double x) { return std::isfinite(x) && x > 0; }, "a positive number"};
}

AdmissibleRange non_negative_numbers() {
  return {[](double x) { return std::isfinite(x) && x >= 0; }, "zero or positive"};
}

AdmissibleRange closed_interval(double least, double greatest) {
  return {[=](double x) { return x >= least && x <= greatest; },
          fmt::format("between {} and {}", least, greatest)};
}

AdmissibleRange open_interval(double least, double greatest) {
  return {[=](double x) { return x > least && x < greatest; },
          fmt::format("above {} and below {}", least, greatest)};
}

AdmissibleRange even_integers_between(int least, int greatest) {
  return {[=](double x) { return x >= least && x <= greatest && std::fmod(x, 2) == 0; },
          fmt::format("an even number from {} to {}", least, greatest)};
}

}  // namespace fpkcheck::base
