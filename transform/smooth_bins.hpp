#pragma once

#include <limits>
#include <vector>

#include "transform/marginal_density.hpp"

namespace fpkcheck::transform {

/// Smooth bins: bin b, b = 0 .. count - 1, has the weight function M((x - first)/spacing - b),
/// where M is the cubic cardinal B-spline with support (-2, 2). The weight functions of all bins
/// have the sum 1. The average over a sharp bin is a non-smooth functional of the trajectories,
/// since trajectories graze the edges of the bin. A simulation can compute the average over a
/// smooth bin with an error of 1e-6.
struct SmoothBins {
  double first = 0;  ///< centre of bin 0
  double spacing = 1;
  int count = 0;
  /// Lower end of the range of the variable; for y the end is the wall. The distance from this end
  /// to `first` is an integer multiple of the spacing.
  double from = -std::numeric_limits<double>::infinity();

  bool operator==(const SmoothBins&) const = default;
};

double cardinal_cubic_spline(double t);
/// Returns the weight of bin b, the integral of M((x - first)/spacing - b) over x > from.
double smooth_bin_weight(const SmoothBins& bins, int bin);

/// Converts averages over smooth bins to a marginal. The width of bin b in the marginal is
/// smooth_bin_weight(bins, b), and therefore sums of averages times widths are integrals.
Marginal smooth_bin_marginal(const SmoothBins& bins, std::vector<double> averages);

/// Averages a density p on sharp bins over smooth bins. The average over a smooth bin with the
/// weight function M is int M p dx / smooth_bin_weight(). ConservativeRemap interpolates the
/// cumulative distribution F of p between the edges, and Boole's rule computes int M p dx = -int M'
/// F dx. Beyond the edges of the sharp bins the density is taken as 0.
/// @param sharp density on sharp bins, which must be narrower than the smooth bins
Marginal average_over_smooth_bins(const Marginal& sharp, const SmoothBins& bins);

}  // namespace fpkcheck::transform
