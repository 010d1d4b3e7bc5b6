#pragma once

#include <vector>

#include "transform/marginal.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// Contribution of the rest atoms to the L1 distance of two marginals. P0 and Q0 are the atoms of
/// the two solutions at a wall. For y the contribution is the sum of |P0 - Q0| over the walls. For
/// y' all atoms are at y' = 0, and the contribution is |sum of P0 - sum of Q0|.
double rest_atom_l1_distance(const std::vector<transform::RestAtom>& a,
                             const std::vector<transform::RestAtom>& b,
                             transform::Variable variable);

}  // namespace fpkcheck::compare
