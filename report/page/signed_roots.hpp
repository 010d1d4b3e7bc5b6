#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fpkcheck::report {

/// Numbers of either sign in two bytes each: sign(q) (q / 32767)^2 times the largest. The root keeps
/// small ones, those of the tails, to few per cent.
struct SignedRoots {
  double largest;  ///< in magnitude
  std::vector<std::int16_t> roots;
};
SignedRoots signed_roots(std::span<const double> values);

}  // namespace fpkcheck::report
