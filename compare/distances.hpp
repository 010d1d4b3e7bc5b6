#pragma once

#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// The logarithmic distance of a density a from a reference density b in the tail: over the bins in
/// which b is in one decade.
struct TailDistance {
  double from;
  double to;        ///< upper limit of the decade, from <= b < to
  double mean_abs;  ///< mean of |log10 a - log10 b| over the used bins; NaN without used bins
  int bins;
  /// Number of bins omitted because a is not positive, or because the 95 % confidence interval of a
  /// or b is too wide.
  int bins_omitted;
};

/// Distances of a density a from a reference density b. Integrals are sums over the common bins.
struct Distances {
  double l1;   ///< int |a - b|: from 0 (equal) to 2 (disjoint)
  double l2;   ///< sqrt(int (a - b)^2)
  double sup;  ///< max |a - b|
  /// Hellinger distance sqrt(1/2 int (sqrt a - sqrt b)^2). The distance equals sqrt(1 - int
  /// sqrt(ab)) if both densities have mass 1.
  double hellinger;
  /// Kullback-Leibler divergence KL(b || a), which may be infinite: the information lost if a
  /// replaces the reference b.
  double kl;
  /// Tail distances in the decades of b from 0.1 .. 1 down to 1e-6 .. 1e-5.
  std::vector<TailDistance> log10_tail;
};

/// Returns whether the 95 % confidence interval of a bin is within +-50 % of the density in the
/// bin. A marginal density without confidence intervals counts as exact, with the result `true`.
bool has_narrow_confidence_interval(const transform::Marginal& marginal, std::size_t bin);

/// Computes the distances of the marginal density a from the reference marginal density b. Where
/// averages are negative, l1, l2 and sup use the negative averages, and hellinger and kl use 0. The
/// divergence KL(b || a) is int (b log(b/a) - b + a), which is never negative and equals int b
/// log(b/a) for equal masses. The divergence is infinite if b > 0 and a = 0 in the same bin. Tail
/// distances omit bins without has_narrow_confidence_interval(), since sampling noise would
/// otherwise count as an error. All distances are NaN if an average is not finite.
/// @throws std::invalid_argument if the bins differ or the sizes of a marginal are inconsistent
Distances distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
