#pragma once

#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::gaussian {

/// Returns the projected equations for the point-symmetric monomials.
inline ProjectedEquations projection_of(const problem::Problem& problem, int order) {
  return ProjectedEquations(GaussianWeightedBasis(order, MonomialSet::point_symmetric,
                                                  gaussian_weight_deviations(problem)));
}

}  // namespace fpkcheck::epc::gaussian
