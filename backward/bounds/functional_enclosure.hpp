#pragma once

#include "backward/bounds/functional.hpp"
#include "numerics/interval/bernstein.hpp"

namespace fpkcheck::backward {

/// Enclosed Bernstein coefficients of the integrand on the segment from `from` to `to` of its axis.
/// The segment lies within a smooth piece of the integrand, except for rounding of the ends.
numerics::BernsteinCoefficients integrand_enclosure(const Functional& functional,
                                                    const problem::Problem& problem,
                                                    const numerics::Interval& from,
                                                    const numerics::Interval& to, int degree);

/// An upper bound of |f| for 0 <= y <= `y`, |v| <= `v` and k y + mu y^3 <= `force`. The bound is a
/// polynomial of degree <= 4 in these arguments with nonnegative coefficients.
numerics::Interval integrand_magnitude_bound(const Functional& functional,
                                             const numerics::Interval& y,
                                             const numerics::Interval& v,
                                             const numerics::Interval& force);

/// Enclosure of the functional, computed from an enclosure of the mean of its integrand.
numerics::Enclosure enclose_functional(const Functional& functional,
                                       const problem::Problem& problem,
                                       const numerics::Enclosure& mean);

}  // namespace fpkcheck::backward
