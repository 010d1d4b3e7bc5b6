#pragma once

#include <Eigen/Core>

#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::numerics {

/// Bezier extraction: a matrix whose row l contains the Bernstein coefficients of basis function
/// span + l on the segment from `from` to `to`. The segment may be a part of the span, and `from`
/// may be above `to`. If the segment extends beyond the span, the polynomial of the span is
/// extrapolated. Coefficient j is the value of the blossom (polar form) for p - j arguments equal
/// to `from` and j arguments equal to `to`, computed with de Boor's recursion.
/// @tparam Real double; an interval type gives enclosures of the coefficients
/// @return shape (degree + 1, degree + 1)
template <class Real>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> bezier_extraction(const SplineBasis& basis,
                                                                      int span, const Real& from,
                                                                      const Real& to) {
  const int p = basis.degree();
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> rows(p + 1, p + 1), d(p + 1, p + 1);
  for (int j = 0; j <= p; ++j) {
    for (int i = 0; i <= p; ++i) {  // control point i, as a combination of the basis functions l
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
