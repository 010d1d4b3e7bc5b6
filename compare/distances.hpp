#pragma once

#include <vector>

#include "transform/marginal_density.hpp"

namespace fpkcheck::compare {

/// The mean absolute difference of the log10 of a density a and a reference density b over the bins
/// in which b is in one decade.
struct LogarithmicTailDistance {
  double from;
  double to;        ///< upper limit of the decade from <= b < to
  double mean_abs;  ///< mean of |log10 a - log10 b| over the used bins; NaN without used bins
  int bins;
  /// Number of bins omitted from the tail distance since the density a is not positive or a 95 %
  /// confidence interval is too wide.
  int omitted_bin_count;
};

/// Distances of a density a from a reference density b. The integrals in the distances of two
/// densities a and b are sums over their common bins.
struct DensityDistances {
  double l1;   ///< L1 distance int |a - b|, from 0 (equal) to 2 (disjoint)
  double l2;   ///< L2 distance sqrt(int (a - b)^2)
  double sup;  ///< supremum distance max |a - b|
  /// Hellinger distance sqrt(1/2 int (sqrt a - sqrt b)^2) of two densities a and b. For densities a
  /// and b of mass 1 the Hellinger distance is sqrt(1 - int sqrt(ab)).
  double hellinger;
  /// Kullback-Leibler divergence KL(b || a) of a reference density b from a density a.
  double kl;
  /// Distances of the logarithms for decades of the reference density, 0.1 .. 1 to 1e-6 .. 1e-5.
  std::vector<LogarithmicTailDistance> log10_tail;
};

/// Returns whether the 95 % confidence interval of the density in a bin is within +-50 % of the
/// density. For a marginal density without confidence intervals the result is `true`.
bool has_narrow_confidence_interval(const transform::Marginal& marginal, std::size_t bin);

/// Computes the distances of the marginal density a from the reference marginal density b. Negative
/// averages of a density enter the L1, L2 and supremum distances unchanged; the Hellinger distance
/// and the Kullback-Leibler divergence replace negative averages by 0. The Kullback-Leibler
/// divergence KL(b || a) is int (b log(b/a) - b + a), which is never negative and equals int b
/// log(b/a) for densities of equal mass. The Kullback-Leibler divergence KL(b || a) is infinite if
/// b > 0 and a = 0 in the same bin. The distances of the logarithms omit bins with wide confidence
/// intervals, since sampling noise would dominate the distance there. All distances are NaN if the
/// average of a density over a bin is not finite.
/// @throws std::invalid_argument if the bins differ or the sizes of a marginal are inconsistent
DensityDistances compute_distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
