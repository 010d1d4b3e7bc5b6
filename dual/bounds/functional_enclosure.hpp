#pragma once

#include "dual/bounds/functional.hpp"
#include "dual/interval/bernstein.hpp"

namespace fpkcheck::dual {

/// The integrand on a segment of its axis, within one of its smooth pieces up to the rounding of
/// the segment's ends: enclosed Bernstein coefficients of a degree.
Coefficients integrand_on(const Functional& functional, const problem::Problem& problem,
                          const Interval& from, const Interval& to, int degree);

/// A bound of |f| where 0 <= y <= `y`, |v| <= `v` and k y + mu y^3 <= `force`; with these it is a
/// polynomial in them of degree <= 4 without negative coefficients.
Interval largest_integrand(const Functional& functional, const Interval& y, const Interval& v,
                           const Interval& force);

/// E[functional] from an enclosure of the integrand's mean.
Enclosure functional_value(const Functional& functional, const problem::Problem& problem,
                           const Enclosure& mean);

}  // namespace fpkcheck::dual
