#pragma once

#include "backward/generator/collocation.hpp"
#include "backward/generator/velocity_operators.hpp"

namespace fpkcheck::backward {

/// Values of the velocity factors of the generator at `points_per_cell` Chebyshev points of every
/// cell of v.
VelocitySamples velocity_samples(const VelocityOperators& operators, const ImpactBasis& basis,
                                 int points_per_cell);

}  // namespace fpkcheck::backward
