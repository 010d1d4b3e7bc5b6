#pragma once

#include <limits>
#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::transform {

/// Bins weighted by the cubic cardinal B-splines M((x - first)/spacing - b), b = 0 .. count - 1, of
/// support (-2, 2) and sum 1. An average over a sharp bin depends on the orbits that graze its
/// edges and is not a smooth functional; an average over a smooth bin can be computed to 1e-6.
struct SmoothBins {
  double first = 0;  ///< centre of bin 0
  double spacing = 1;
  int count = 0;
  /// Lower end of the variable (the wall, for y), a whole number of spacings from `first`.
  double from = -std::numeric_limits<double>::infinity();

  bool operator==(const SmoothBins&) const = default;
};

/// M(t).
double cubic_spline(double t);
/// int M((x - first)/spacing - b) dx over x > from.
double bin_weight(const SmoothBins& bins, int bin);

/// Converts averages over smooth bins to a marginal. The width of bin b is its weight, so that sums
/// over the bins are integrals; bins far from `from` keep their centres.
/// @param averages shape (count)
Marginal smooth_bin_marginal(const SmoothBins& bins, std::vector<double> averages);

/// Averages int M p dx / weight of a density on sharp bins: ConservativeRemap interpolates the
/// cumulative distribution between the edges, and Boole's rule integrates it against -M'. The
/// density is 0 beyond the edges.
/// @param sharp its bins must be narrower than the smooth bins
Marginal smooth_averages(const Marginal& sharp, const SmoothBins& bins);

}  // namespace fpkcheck::transform
