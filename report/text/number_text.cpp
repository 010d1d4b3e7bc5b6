#include "report/text/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace fpkcheck::report {
namespace {

bool is_finite_number(const std::optional<double>& value) { return value && std::isfinite(*value); }

// Removes the leading zeros of a decimal exponent: "1.2e-05" becomes "1.2e-5".
std::string without_padded_exponent(std::string text) {
  const auto e = text.find('e');
  if (e == std::string::npos || e + 2 >= text.size()) return text;
  while (text[e + 2] == '0' && e + 3 < text.size()) text.erase(e + 2, 1);
  if (text[e + 1] == '+') text.erase(e + 1, 1);
  return text;
}

// Removes a decimal point without digits after the point from the text of a number. In fmt, the
// format flag "#" keeps trailing zeros and the decimal point, after which some versions of fmt add
// a zero. With three significant digits both "150." and "150.0" become "150".
std::string without_bare_point(std::string text, int digits) {
  const auto point = text.find('.');
  if (point == std::string::npos) return text;
  const auto before = point - (text[0] == '-' ? 1 : 0);
  if (before < static_cast<std::size_t>(digits)) return text;
  return text.erase(point, text.find('e', point) - point);
}

}  // namespace

std::string number_text(const std::optional<double>& value, int digits) {
  if (!is_finite_number(value)) return std::string(kNoValue);
  if (*value == 0) return "0";
  if (digits == 1) return without_padded_exponent(fmt::format("{:.0e}", *value));
  return without_padded_exponent(
      without_bare_point(fmt::format("{:#.{}g}", *value, digits), digits));
}

std::string parameter_value_text(const base::Value& value, int digits) {
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "yes" : "no";
  if (const auto* count = std::get_if<std::int64_t>(&value)) return fmt::format("{}", *count);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr || !std::isfinite(*number)) return std::string(kNoValue);
  return without_padded_exponent(fmt::format("{:.{}g}", *number, digits));
}

std::string l1_distance_cell_text(const std::optional<double>& l1) { return number_text(l1, 2); }

std::string seconds_text(const std::optional<double>& seconds) {
  if (!is_finite_number(seconds)) return std::string(kNoValue);
  if (*seconds < 10) return number_text(seconds, 2);
  return fmt::format("{:.{}f}", *seconds, *seconds < 100 ? 1 : 0);
}

std::string l1_distance_text(double l1) {
  constexpr double kTwoDigits = 1e-4;
  if (l1 == 0) return "0";
  return l1 < kTwoDigits ? fmt::format("{:.1e}", l1) : fmt::format("{:.5f}", l1);
}

IntervalText round_interval_outward(double lower, double upper) {
  constexpr int kMostDecimals = 15;  // number of decimals of a double of order 1
  const double width = upper - lower;
  if (!std::isfinite(width)) return {fmt::format("{}", lower), fmt::format("{}", upper)};
  const int decimals =
      width > 0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(width))), 0, kMostDecimals)
                : kMostDecimals;
  const double unit = std::pow(10.0, decimals);
  // The function fma gives the sign of the rounding error of a product, and thus the direction in
  // which a rounded end is corrected.
  double down = std::floor(lower * unit), up = std::ceil(upper * unit);
  if (down == lower * unit && std::fma(lower, unit, -down) < 0) down -= 1;
  if (up == upper * unit && std::fma(upper, unit, -up) > 0) up += 1;
  return {fmt::format("{:.{}f}", down / unit, decimals),
          fmt::format("{:.{}f}", up / unit, decimals)};
}

}  // namespace fpkcheck::report
