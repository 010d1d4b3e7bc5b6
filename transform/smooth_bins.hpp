#pragma once

#include <limits>
#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::transform {

/// Cubic cardinal B-splines M((x - first)/spacing - b), b = 0 .. count - 1, where M lives on
/// (-2, 2): bins with soft edges, whose sum is 1. Sharp edges make an average depend on orbits that
/// graze them, where no smooth function follows it; over these it can be known to 1e-6.
struct SmoothBins {
  double first = 0;  ///< centre of bin 0
  double spacing = 1;
  int count = 0;
  /// Where the variable begins, a whole number of spacings from `first`: the wall, for y.
  double from = -std::numeric_limits<double>::infinity();

  bool operator==(const SmoothBins&) const = default;
};

/// M(t).
double cubic_spline(double t);
/// int M((x - first)/spacing - b) dx over x > from.
double bin_weight(const SmoothBins& bins, int bin);

/// Averages over smooth bins as a marginal: bin b is as wide as its weight, so that sums over the
/// bins are integrals, and those far from `from` have the bins' centres.
/// @param averages shape (count)
Marginal marginal_of(const SmoothBins& bins, std::vector<double> averages);

/// The averages of a density that is known by sharp bins, int M p dx / weight: the cumulative
/// distribution between the edges by MassTransfer, integrated against -M' by Boole's rule. What
/// lies beyond the edges counts as 0.
/// @param sharp bins narrower than the smooth ones
Marginal smooth_averages(const Marginal& sharp, const SmoothBins& bins);

}  // namespace fpkcheck::transform
