#include "report/page/signed_roots.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fpkcheck::report {

SignedRoots signed_roots(std::span<const double> values, int levels) {
  SignedRoots result{.largest = 0, .levels = levels, .roots = {}};
  for (const double x : values) result.largest = std::max(result.largest, std::abs(x));
  for (const double x : values) {
    const double root = result.largest > 0 ? std::sqrt(std::abs(x) / result.largest) : 0;
    result.roots.push_back(static_cast<int>(std::lround(std::copysign(levels * root, x))));
  }
  return result;
}

std::vector<int> successive_differences(std::span<const int> values) {
  std::vector<int> steps(values.size());
  std::adjacent_difference(values.begin(), values.end(), steps.begin());
  return steps;
}

}  // namespace fpkcheck::report
