#pragma once

#include <vector>

#include "transform/marginal.hpp"

namespace fpkcheck::compare {

/// How far two densities are apart in one decade of the reference density.
struct TailDistance {
  double from;  ///< the decade: from <= b < to
  double to;
  double mean_abs;  ///< mean of |log10 a - log10 b| over `bins`; NaN when there is none
  int bins;         ///< bins of the decade that were used
  int left_out;     ///< bins of the decade where a is not positive or an interval is too wide
};

/// Distances of a density `a` from a reference `b`; integrals are sums over the common bins.
struct Distances {
  double l1;   ///< int |a - b|: from 0 (equal) to 2 (disjoint)
  double l2;   ///< sqrt(int (a - b)^2)
  double sup;  ///< max |a - b|
  double
      hellinger;  ///< sqrt(1/2 int (sqrt a - sqrt b)^2), = sqrt(1 - int sqrt(ab)) for unit masses
  double kl;      ///< KL(b || a), what is lost when a is taken for the reference b; may be infinite
  std::vector<TailDistance> log10_tail;  ///< decades 0.1 .. 1 down to 1e-6 .. 1e-5
};

/// False where the 95 % interval of a bin is wider than +-50 % of its density.
bool known_well(const transform::Marginal& marginal, std::size_t bin);

/// Compares bin by bin. A negative average (a discretisation can have one) counts as it is in l1,
/// l2 and sup, and as zero in hellinger and kl. KL(b || a) is infinite where b > 0 = a; it is taken
/// in the form int (b log(b/a) - b + a), which is the usual one for equal masses and never
/// negative, so that mass beyond the axes does not spoil it. In the tail, a bin whose 95 % interval
/// is wider than +-50 % of the density is left out, so that noise is not called error. All are NaN
/// when an average is not finite.
/// @throws std::invalid_argument when the bins differ or the shapes do not fit
Distances distances(const transform::Marginal& a, const transform::Marginal& b);

}  // namespace fpkcheck::compare
