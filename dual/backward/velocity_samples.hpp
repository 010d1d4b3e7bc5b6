#pragma once

#include "dual/backward/collocation.hpp"
#include "dual/backward/velocity_operators.hpp"

namespace fpkcheck::dual {

/// The operators at `per_cell` Chebyshev points of every cell of v.
VelocitySamples velocity_samples(const VelocityOperators& operators, const ImpactBasis& basis,
                                 int per_cell);

}  // namespace fpkcheck::dual
