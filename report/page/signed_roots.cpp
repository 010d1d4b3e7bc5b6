#include "report/page/signed_roots.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::report {

SignedRoots signed_roots(std::span<const double> values) {
  SignedRoots result{.largest = 0, .roots = {}};
  for (const double x : values) result.largest = std::max(result.largest, std::abs(x));
  for (const double x : values) {
    const double root = result.largest > 0 ? std::sqrt(std::abs(x) / result.largest) : 0;
    result.roots.push_back(static_cast<std::int16_t>(std::lround(std::copysign(32767 * root, x))));
  }
  return result;
}

}  // namespace fpkcheck::report
