#pragma once

#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// Tail distance: the logarithmic distance of a density a from a reference density b, over the bins
/// in which b is in one decade of density.
struct TailDistance {
  double from;      ///< lower limit of the decade: from <= b < to
  double to;        ///< upper limit of the decade
  double mean_abs;  ///< mean of |log10 a - log10 b| over the used bins; NaN without a bin
  int bins;         ///< number of used bins
  /// Number of omitted bins: those where a is not positive, or where the 95 % confidence interval
  /// of a or b is too wide.
  int bins_omitted;
};

/// Distances of a density a from a reference density b. Integrals are sums over the common bins.
struct Distances {
  double l1;   ///< int |a - b|: from 0 (equal) to 2 (disjoint)
  double l2;   ///< sqrt(int (a - b)^2)
  double sup;  ///< max |a - b|
  /// Hellinger distance sqrt(1/2 int (sqrt a - sqrt b)^2); equal to sqrt(1 - int sqrt(ab)) if both
  /// densities have mass 1.
  double hellinger;
  /// Kullback-Leibler divergence KL(b || a): the information lost if a replaces the reference b.
  /// May be infinite.
  double kl;
  /// Tail distances in the decades of b from 0.1 .. 1 down to 1e-6 .. 1e-5.
  std::vector<TailDistance> log10_tail;
};

/// Whether the 95 % confidence interval of a bin is within +-50 % of the density in the bin. A
/// marginal without confidence intervals counts as exact: the result is true.
bool has_narrow_confidence_interval(const transform::Marginal& marginal, std::size_t bin);

/// Computes the distances of the marginal a from the reference marginal b. Discretisations can
/// produce negative averages: l1, l2 and sup use the negative values, hellinger and kl use zero
/// instead. The divergence KL(b || a) is computed as int (b log(b/a) - b + a). The integral is
/// never negative, even if some mass is beyond the axes, and equals the standard form int b
/// log(b/a) for equal masses. The divergence is infinite if b > 0 and a = 0 in the same bin. A tail
/// distance omits bins whose 95 % confidence interval is wider than +-50 % of the density, so that
/// sampling noise does not count as error. All distances are NaN if an average is not finite.
/// @throws std::invalid_argument when the bins differ or the sizes of a marginal are inconsistent
Distances distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
