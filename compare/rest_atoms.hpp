#pragma once

#include <vector>

#include "transform/marginal.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// What atoms of rest add to the L1 distance of two marginals: the sum of |P0 - Q0| over the walls in
/// y; in y', where all of them are at 0, the difference of their sums.
double atom_distance(const std::vector<transform::RestAtom>& a,
                     const std::vector<transform::RestAtom>& b, transform::Variable variable);

}  // namespace fpkcheck::compare
