#pragma once

#include <vector>

#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// Returns the contribution of the atoms at rest (probabilities of rest in contact with a wall) to
/// the L1 distance of two marginal densities. Let P0 and Q0 be the probabilities of rest at a wall
/// in the two solutions. For p(y) the contribution of the atoms is the sum over the walls of the
/// difference |P0 - Q0| of the rest probabilities of the two solutions. For p(y') the contribution
/// of the atoms is the difference |sum of P0 - sum of Q0| of the total probabilities of rest, since
/// all atoms are at y' = 0.
double rest_atom_l1_distance(const std::vector<transform::RestAtom>& a,
                             const std::vector<transform::RestAtom>& b,
                             transform::StateVariable variable);

}  // namespace fpkcheck::compare
