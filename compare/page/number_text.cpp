#include "compare/page/number_text.hpp"

#include <fmt/format.h>

#include "compare/page/html.hpp"
#include "compare/text/l1_text.hpp"

namespace fpkcheck::compare {
namespace {

// "1.2e-05" is "1.2e-5".
std::string without_padded_exponent(std::string text) {
  const auto e = text.find('e');
  if (e == std::string::npos || e + 2 >= text.size()) return text;
  while (text[e + 2] == '0' && e + 3 < text.size()) text.erase(e + 2, 1);
  if (text[e + 1] == '+') text.erase(e + 1, 1);
  return text;
}

// "#" keeps zeros, and a point with nothing (or, by some versions, one zero) behind it: "150." and
// "150.0" of three digits are "150".
std::string without_bare_point(std::string text, int digits) {
  const auto point = text.find('.');
  if (point == std::string::npos) return text;
  const auto before = point - (text[0] == '-' ? 1 : 0);
  if (before < static_cast<std::size_t>(digits)) return text;
  return text.erase(point, text.find('e', point) - point);
}

}  // namespace

std::string number_text(const std::optional<double>& value, int digits) {
  if (!value) return std::string(kNoValue);
  if (*value == 0) return "0";
  if (digits == 1) return without_padded_exponent(fmt::format("{:.0e}", *value));
  return without_padded_exponent(
      without_bare_point(fmt::format("{:#.{}g}", *value, digits), digits));
}

std::string plain_text(const std::optional<double>& value) {
  return value ? without_padded_exponent(fmt::format("{:.6g}", *value)) : std::string(kNoValue);
}

std::string l1_cell(const std::optional<double>& l1) {
  return l1 ? without_padded_exponent(l1_text(*l1)) : std::string(kNoValue);
}

std::string seconds_text(const std::optional<double>& seconds) {
  if (!seconds) return std::string(kNoValue);
  if (*seconds < 10) return number_text(seconds, 2);
  return fmt::format("{:.{}f}", *seconds, *seconds < 100 ? 1 : 0);
}

std::string word(const nlohmann::ordered_json& object, std::string_view key) {
  if (!object.is_object()) return std::string(kNoValue);
  const auto found = object.find(key);
  const bool is_text = found != object.end() && found->is_string();
  return is_text ? found->get<std::string>() : std::string(kNoValue);
}

}  // namespace fpkcheck::compare
