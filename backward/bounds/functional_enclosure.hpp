#pragma once

#include "backward/bounds/functional.hpp"
#include "numerics/interval/bernstein.hpp"

namespace fpkcheck::backward {

/// The integrand on a segment of its axis, within one of its smooth pieces up to the rounding of
/// the segment's ends: enclosed Bernstein coefficients of a degree.
numerics::BernsteinCoefficients integrand_on(const Functional& functional,
                                             const problem::Problem& problem,
                                             const numerics::Interval& from,
                                             const numerics::Interval& to, int degree);

/// A bound of |f| where 0 <= y <= `y`, |v| <= `v` and k y + mu y^3 <= `force`; with these it is a
/// polynomial in them of degree <= 4 without negative coefficients.
numerics::Interval largest_integrand(const Functional& functional, const numerics::Interval& y,
                                     const numerics::Interval& v, const numerics::Interval& force);

/// E[functional] from an enclosure of the integrand's mean.
numerics::Enclosure functional_value(const Functional& functional, const problem::Problem& problem,
                                     const numerics::Enclosure& mean);

}  // namespace fpkcheck::backward
