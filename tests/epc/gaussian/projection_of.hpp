#pragma once

#include "epc/gaussian/projection.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::gaussian {

/// On the monomials of a point-symmetric closure.
inline Projection projection_of(const problem::Problem& problem, int order) {
  return Projection(Basis(order, MonomialSet::point_symmetric, deviations(problem)));
}

}  // namespace fpkcheck::epc::gaussian
