#pragma once

#include <span>
#include <vector>

namespace fpkcheck::report {

/// Numbers of either sign as whole ones: sign(q) (q / levels)^2 times the largest. The root keeps
/// small ones, those of the tails.
struct SignedRoots {
  double largest;  ///< in magnitude
  int levels;
  std::vector<int> roots;  ///< from -levels to levels
};

/// @param levels the smallest that is told from nought is the largest over 4 levels^2
SignedRoots signed_roots(std::span<const double> values, int levels);

/// Each number less the one before it: what is smooth becomes small numbers, which pack well.
std::vector<int> steps_of(std::span<const int> values);

}  // namespace fpkcheck::report
