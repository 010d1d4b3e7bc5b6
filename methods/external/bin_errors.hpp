#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "methods/external/between_walls.hpp"

namespace fpkcheck::methods {

/// The error of a density's average over a bin: the sum of factors[k] * z[first + k], with the
/// errors z of the points in units of their standard errors, independent.
struct BinError {
  double width;
  std::size_t first = 0;        ///< point
  std::vector<double> factors;  ///< of it and the following ones; empty outside the points

  double standard() const;
};

/// Errors of averages over bins of a density given at points with independent errors, straight
/// between them.
/// @param knots abscissae of the points, and before or after them those to which it is continued
/// @param continued where the density at the first or last knot, which is no point then, continues
///        the straight line through the next two
std::vector<BinError> bin_errors(std::span<const double> knots, std::span<const double> errors,
                                 std::span<const double> edges, const Reached& continued);

/// How far from the truth chance takes the density, in L1 over the bins.
struct BinSamplingL1 {
  double expected = 0;     ///< sum over bins of sqrt(2/pi) * standard error * width
  double quantile_99 = 0;  ///< what 99 files of 100 stay below
};

BinSamplingL1 sampling_l1(std::span<const BinError> bins);

}  // namespace fpkcheck::methods
