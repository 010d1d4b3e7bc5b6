#pragma once

#include <span>
#include <vector>

namespace fpkcheck::report {

/// Signed numbers quantised to integers q: a value is sign(q) (q / levels)^2 times the largest
/// magnitude. The square root resolves the small values of the tails.
struct SignedRoots {
  double largest;  ///< largest magnitude
  int levels;
  std::vector<int> roots;  ///< from -levels to levels
};

/// Quantises values.
/// @param levels number of steps; magnitudes below the largest / (4 levels^2) become 0
SignedRoots signed_roots(std::span<const double> values, int levels);

/// Differences of successive numbers, after the first number: small for smooth data, which
/// compresses well.
std::vector<int> successive_differences(std::span<const int> values);

}  // namespace fpkcheck::report
