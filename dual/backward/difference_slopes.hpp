#pragma once

#include "dual/interval/bernstein.hpp"
#include "dual/spline/basis.hpp"

namespace fpkcheck::dual {

/// With S_l = B_{span+l} + B_{span+l+1} + .. on a span, whose first is 1, the derivative of a
/// spline is sum_{l=1}^p (c_{span+l} - c_{span+l-1}) S_l'. These are the S_l', by
///
///     S_l' = p N_{span+l} / (t_{span+l+p} - t_{span+l}),   N of degree p - 1 on the same knots,
///
/// enclosed on the segment from `from` to `to`. de Boor, A Practical Guide to Splines, ch. X.
std::vector<Coefficients> difference_slopes(const SplineBasis& basis, int span,
                                            const Interval& from, const Interval& to);

}  // namespace fpkcheck::dual
