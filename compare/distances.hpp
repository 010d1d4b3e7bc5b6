#pragma once

#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// Logarithmic distance of two densities in a decade of the reference density.
struct TailDistance {
  double from;  ///< the decade: from <= b < to
  double to;
  double mean_abs;   ///< mean of |log10 a - log10 b| over `bins`; NaN without a bin
  int bins;          ///< number of bins used
  int bins_omitted;  ///< number of bins omitted: a not positive, or an interval too wide
};

/// Distances of a density `a` from a reference `b`. Integrals are sums over the common bins.
struct Distances {
  double l1;   ///< int |a - b|: from 0 (equal) to 2 (disjoint)
  double l2;   ///< sqrt(int (a - b)^2)
  double sup;  ///< max |a - b|
  double
      hellinger;  ///< sqrt(1/2 int (sqrt a - sqrt b)^2), = sqrt(1 - int sqrt(ab)) for unit masses
  double kl;  ///< KL(b || a), the information lost if a replaces the reference b; may be infinite
  std::vector<TailDistance> log10_tail;  ///< decades 0.1 .. 1 down to 1e-6 .. 1e-5
};

/// False if the 95 % interval of a bin is wider than +-50 % of its density.
bool has_narrow_interval(const transform::Marginal& marginal, std::size_t bin);

/// Compares two marginals bin by bin. Negative averages, which discretisations can produce, keep
/// their values in l1, l2 and sup and count as zero in hellinger and kl. KL(b || a) is infinite if
/// b > 0 = a in some bin. It is computed as int (b log(b/a) - b + a): never negative, and equal to
/// the standard form for equal masses, so that mass beyond the axes has no effect. The tail omits
/// bins whose 95 % interval is wider than +-50 % of the density, so that sampling noise does not
/// count as error. All distances are NaN if an average is not finite.
/// @throws std::invalid_argument when the bins differ or the sizes of a marginal are inconsistent
Distances distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
