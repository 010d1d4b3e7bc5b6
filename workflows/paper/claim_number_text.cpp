#include "workflows/paper/claim_number_text.hpp"

#include <fmt/format.h>

#include "report/text/number_text.hpp"

namespace fpkcheck::paper {
namespace {

// Trailing zeros, as in "0.02000", would suggest more significant digits than a criterion has.
std::string without_trailing_zeros(std::string number) {
  if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  return number.ends_with('.') ? number.substr(0, number.size() - 1) : number;
}

}  // namespace

std::string l1_distance_text(const std::optional<double>& l1) {
  return l1 ? without_trailing_zeros(report::l1_distance_text(*l1)) : "";
}

std::string tail_text(const std::optional<double>& tail) {
  return tail ? without_trailing_zeros(fmt::format("{:.3f}", *tail)) : "";
}

}  // namespace fpkcheck::paper
