#pragma once

#include <vector>

#include "transform/marginal_density.hpp"

namespace fpkcheck::compare {

/// The logarithmic distance of a density a from a reference density b over the tail bins in which b
/// is in one decade.
struct LogarithmicTailDistance {
  double from;
  double to;        ///< upper limit of the decade from <= b < to
  double mean_abs;  ///< mean of |log10 a - log10 b| over the used bins; NaN without used bins
  int bins;
  /// Number of tail bins that are omitted since the density a is not positive or a 95 % confidence
  /// interval is too wide.
  int omitted_bin_count;
};

/// Distances of a density a from a reference density b. The integrals in the distances are sums
/// over the common bins of the densities a and b.
struct DensityDistances {
  double l1;   ///< L1 distance int |a - b|, from 0 (equal) to 2 (disjoint)
  double l2;   ///< L2 distance sqrt(int (a - b)^2)
  double sup;  ///< supremum distance max |a - b|
  /// Hellinger distance sqrt(1/2 int (sqrt a - sqrt b)^2). For densities of mass 1 the Hellinger
  /// distance is sqrt(1 - int sqrt(ab)).
  double hellinger;
  /// Kullback-Leibler divergence KL(b || a) of the reference b from a; may be infinite.
  double kl;
  /// Tail distances in the decades of the reference density, from 0.1 .. 1 down to 1e-6 .. 1e-5.
  std::vector<LogarithmicTailDistance> log10_tail;
};

/// Returns whether the 95 % confidence interval of a bin is within +-50 % of the density in the
/// bin. The result is `true` for a marginal density without confidence intervals.
bool has_narrow_confidence_interval(const transform::Marginal& marginal, std::size_t bin);

/// Computes the distances of the marginal density a from the reference marginal density b. The L1,
/// L2 and supremum distances use negative averages unchanged; the Hellinger distance and the
/// Kullback-Leibler divergence replace negative averages by 0. The divergence KL(b || a) is int (b
/// log(b/a) - b + a), which is never negative and equals int b log(b/a) for equal masses. The
/// divergence KL(b || a) is infinite if b > 0 and a = 0 in the same bin. Tail distances omit bins
/// without has_narrow_confidence_interval(), since sampling noise would dominate the distance
/// there. All distances are NaN if an average of a or b is not finite.
/// @throws std::invalid_argument if the bins differ or the sizes of a marginal are inconsistent
DensityDistances compute_distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
