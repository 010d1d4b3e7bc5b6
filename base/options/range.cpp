#include "base/options/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fpkcheck::base {

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
