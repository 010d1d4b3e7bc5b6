#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "methods/external/between_walls.hpp"

namespace fpkcheck::methods {

/// The error of a density's average over a bin: the sum of factors[k] * z[first + k]. The z are the
/// errors of the points in units of their standard errors, and independent.
struct BinError {
  double width;
  std::size_t first = 0;  ///< index of the first point
  std::vector<double>
      factors;  ///< of this point and the following points; empty outside the points

  /// Standard error of the average.
  double standard_error() const;
};

/// Errors of bin averages of a density that is given at points with independent errors, and linear
/// between the points.
/// @param knots abscissae of the points; also the walls to which the density is extrapolated
/// @param extrapolation whether the first or last knot is a wall: the density there is extrapolated
///        linearly from the next two knots
std::vector<BinError> bin_errors(std::span<const double> knots, std::span<const double> errors,
                                 std::span<const double> edges,
                                 const WallExtrapolation& extrapolation);

/// Sampling error of the density in L1 over the bins.
struct BinSamplingL1 {
  double expected = 0;     ///< sum over bins of sqrt(2/pi) * standard error * width
  double quantile_99 = 0;  ///< 99 % quantile of the L1 distance
};

BinSamplingL1 sampling_l1(std::span<const BinError> bins);

}  // namespace fpkcheck::methods
