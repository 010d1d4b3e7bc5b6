#pragma once

#include <vector>

#include "transform/marginal.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// Contribution of the rest atoms to the L1 distance of two marginals: for y the sum of |P0 - Q0|
/// over the walls; for y', where all atoms are at 0, the difference of the sums.
double atom_distance(const std::vector<transform::RestAtom>& a,
                     const std::vector<transform::RestAtom>& b, transform::Variable variable);

}  // namespace fpkcheck::compare
