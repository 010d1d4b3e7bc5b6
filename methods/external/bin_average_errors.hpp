#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "methods/external/range_between_walls.hpp"

namespace fpkcheck::methods {

/// The sampling error of the average of a density over a bin, sum_k factors[k] z[first + k], where
/// the independent variable z[i] is the error of the density at point i divided by its standard
/// error.
struct BinAverageError {
  double width;
  std::size_t first = 0;  ///< index of the first point of the density that affects the bin
  /// Factors of the errors of the density at the points first, first + 1, ..; empty if no point
  /// affects the bin average.
  std::vector<double> factors;

  double standard_error() const;
};

/// Returns the sampling errors of the averages of a density over bins. The density is taken as
/// linear between the points, at which the errors are independent.
/// @param knots abscissae of the points, and of walls to which the density is extrapolated
/// @param errors standard errors of the density at the points
/// @param extrapolation whether the first or the last knot is a wall, to which the density is
/// extrapolated linearly from the next two knots
std::vector<BinAverageError> compute_bin_average_errors(std::span<const double> knots,
                                                        std::span<const double> errors,
                                                        std::span<const double> edges,
                                                        const WallExtrapolation& extrapolation);

/// L1 sampling error of a density that is given by averages over bins.
struct L1SamplingError {
  /// Expected L1 sampling error, the sum over bins of sqrt(2/pi) times the standard error of the
  /// bin average times the bin width.
  double expected = 0;
  double quantile_99 = 0;
};

L1SamplingError l1_sampling_error(std::span<const BinAverageError> bins);

}  // namespace fpkcheck::methods
