#pragma once

#include <span>
#include <vector>

namespace fpkcheck::report {

/// Signed numbers that are quantised to integers q. An integer q represents the number sign(q) (q /
/// levels)^2 times the largest magnitude. The square root in the quantisation resolves the small
/// values of the tails.
struct SignedRoots {
  double largest;  ///< largest magnitude
  int levels;
  std::vector<int> roots;  ///< from -levels to levels
};

/// Quantises signed numbers to integers by the signed square root.
/// @param levels number of quantisation steps on each side of 0; magnitudes below the largest
///               magnitude / (4 levels^2) become 0
SignedRoots signed_roots(std::span<const double> values, int levels);

/// The first number, followed by the differences of successive numbers. The differences of smooth
/// data are small, and therefore compress well.
std::vector<int> successive_differences(std::span<const int> values);

}  // namespace fpkcheck::report
