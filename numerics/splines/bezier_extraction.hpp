#pragma once

#include <Eigen/Core>

#include "numerics/splines/basis.hpp"

namespace fpkcheck::numerics {

/// Bezier extraction: row l holds the Bernstein coefficients of basis function span + l on the
/// segment between `from` and `to`. The segment may be a part of the span, run backwards, or extend
/// beyond the span, where the polynomial is continued. Coefficient j is the blossom with p - j
/// arguments `from` and j arguments `to`, by de Boor's recursion.
/// @tparam Real double, or an interval for an enclosure
/// @return shape (degree + 1, degree + 1)
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> bezier_extraction(const SplineBasis& basis,
                                                                      int span, const Real& from,
                                                                      const Real& to) {
  const int p = basis.degree();
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> rows(p + 1, p + 1), d(p + 1, p + 1);
  for (int j = 0; j <= p; ++j) {
    for (int i = 0; i <= p; ++i) {  // control point i as a combination of the functions l
      for (int l = 0; l <= p; ++l) d(i, l) = Real(i == l ? 1.0 : 0.0);
    }
    for (int r = 1; r <= p; ++r) {
      const Real argument = r <= p - j ? from : to;
      for (int i = p; i >= r; --i) {
        const Real low = Real(basis.knot(span + i)), high = Real(basis.knot(span + i + p + 1 - r));
        const Real t = (argument - low) / (high - low), s = (high - argument) / (high - low);
        for (int l = i - r; l <= i; ++l) d(i, l) = s * d(i - 1, l) + t * d(i, l);
      }
    }
    for (int l = 0; l <= p; ++l) rows(l, j) = d(p, l);
  }
  return rows;
}

}  // namespace fpkcheck::numerics
