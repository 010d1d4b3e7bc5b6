#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "methods/external/between_walls.hpp"

namespace fpkcheck::methods {

/// The sampling error of the average of a density over a bin, as a linear combination of the errors
/// of the points: the sum of factors[k] * z[first + k]. z[i] is the error of the density at point
/// i, in units of its standard error. The z[i] are independent.
struct BinAverageError {
  double width;           ///< width of the bin
  std::size_t first = 0;  ///< index of the first point with a factor
  /// Factors of the point `first` and the following points. Empty if the bin is outside the points.
  std::vector<double> factors;

  /// Standard error of the average over the bin.
  double standard_error() const;
};

/// The sampling errors of the averages of a density over bins. The density is given at points with
/// independent errors, and is linear between the points.
/// @param knots abscissae of the points, and of the walls to which the density is extrapolated
/// @param errors standard errors of the density at the points
/// @param edges edges of the bins
/// @param extrapolation whether the first or last knot is a wall. The density at that wall is
///        extrapolated linearly from the next two knots
std::vector<BinAverageError> bin_average_errors(std::span<const double> knots,
                                                std::span<const double> errors,
                                                std::span<const double> edges,
                                                const WallExtrapolation& extrapolation);

/// L1 sampling error of a density, as averages over bins.
struct L1SamplingError {
  /// Expected value: the sum over bins of sqrt(2/pi) * standard error * width.
  double expected = 0;
  double quantile_99 = 0;  ///< 99 % quantile of the L1 sampling error
};

/// The L1 sampling error over all bins.
L1SamplingError l1_sampling_error(std::span<const BinAverageError> bins);

}  // namespace fpkcheck::methods
