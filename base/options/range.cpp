#include "base/options/range.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fpkcheck::base {

Range finite_number() {
  return {[](double x) { return std::isfinite(x); }, "a finite number"};
}

Range positive() {
  return {[](double x) { return std::isfinite(x) && x > 0; }, "a positive number"};
}

Range non_negative() {
  return {[](double x) { return std::isfinite(x) && x >= 0; }, "zero or positive"};
}

Range between(double least, double greatest) {
  return {[=](double x) { return x >= least && x <= greatest; },
          fmt::format("between {} and {}", least, greatest)};
}

Range strictly_between(double least, double greatest) {
  return {[=](double x) { return x > least && x < greatest; },
          fmt::format("above {} and below {}", least, greatest)};
}

Range even_between(int least, int greatest) {
  return {[=](double x) { return x >= least && x <= greatest && std::fmod(x, 2) == 0; },
          fmt::format("an even number from {} to {}", least, greatest)};
}

}  // namespace fpkcheck::base
