#include "report/text/l1_text.hpp"

#include <fmt/format.h>

namespace fpkcheck::report {

std::string l1_text(double l1) {
  constexpr double kTwoDigits = 1e-4;
  if (l1 == 0) return "0";
  return l1 < kTwoDigits ? fmt::format("{:.1e}", l1) : fmt::format("{:.5f}", l1);
}

}  // namespace fpkcheck::report
