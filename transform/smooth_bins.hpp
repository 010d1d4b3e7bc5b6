#pragma once

#include <limits>
#include <vector>

#include "transform/marginal_density.hpp"

namespace fpkcheck::transform {

/// Smooth bins: bin b, b = 0 .. count - 1, has the weight function M((x - first)/spacing - b),
/// where M is the cubic cardinal B-spline with support (-2, 2). The weight functions of all smooth
/// bins have the sum 1. The average of a density over a sharp bin is a non-smooth functional of the
/// trajectories, since trajectories graze the edges of the bin. A simulation can compute the
/// average of a density over a smooth bin with an error of 1e-6.
struct SmoothBins {
  double first = 0;  ///< centre of bin 0
  double spacing = 1;
  int count = 0;
  /// Lower end of the range of the variable; the lower end of y is the wall. The distance from the
  /// lower end `from` to `first` is an integer multiple of the spacing.
  double from = -std::numeric_limits<double>::infinity();

  bool operator==(const SmoothBins&) const = default;
};

double cardinal_cubic_spline(double t);
/// Returns the weight of the smooth bin b, the integral of the cubic B-spline M((x - first)/spacing
/// - b) over x > from.
double smooth_bin_weight(const SmoothBins& bins, int bin);

/// Converts averages over smooth bins to a Marginal. The width of bin b in the Marginal is
/// smooth_bin_weight(bins, b), so that sums of averages times widths are integrals.
Marginal smooth_bin_marginal(const SmoothBins& bins, std::vector<double> averages);

/// Averages a density p on sharp bins over smooth bins. The average of the density p over a smooth
/// bin with the weight function M is int M p dx / smooth_bin_weight(). ConservativeRemap
/// interpolates the cumulative distribution F of the density p between the edges of the sharp bins,
/// and Boole's rule computes int M p dx = -int M' F dx. Outside the range of the sharp bins the
/// density is taken as 0.
/// @param sharp density on sharp bins, which must be narrower than the smooth bins
Marginal average_over_smooth_bins(const Marginal& sharp, const SmoothBins& bins);

}  // namespace fpkcheck::transform
