#pragma once

#include "numerics/interval/bernstein.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

/// Enclosures of S_l' on the segment from `from` to `to` of a knot span, where S_l = B_{span+l} +
/// B_{span+l+1} + .. and S_0 = 1. The derivative of a spline with coefficients c is sum_{l=1}^p
/// (c_{span+l} - c_{span+l-1}) S_l' with
///
///     S_l' = p N_{span+l} / (t_{span+l+p} - t_{span+l}),   N of degree p - 1 on the same knots
///
/// (de Boor, A Practical Guide to Splines, ch. X).
std::vector<numerics::BernsteinCoefficients> partial_sum_slopes(const numerics::SplineBasis& basis,
                                                                int span,
                                                                const numerics::Interval& from,
                                                                const numerics::Interval& to);

}  // namespace fpkcheck::backward
