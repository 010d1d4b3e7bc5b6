#pragma once

#include "epc/gaussian/projection.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::gaussian {

/// The projection on the point-symmetric monomials.
inline Projection projection_of(const problem::Problem& problem, int order) {
  return Projection(Basis(order, MonomialSet::point_symmetric, deviations(problem)));
}

}  // namespace fpkcheck::epc::gaussian
