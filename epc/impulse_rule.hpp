#pragma once

#include "epc/gaussian_rules.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc {

/// E[g(Y)] for a smooth g, by the Gauss rule of the law about its mean: Hermite for gaussian,
/// Laguerre on either side for laplace, Legendre for uniform; the atoms themselves for two_point.
/// @param points of the rule, on each side for laplace; atoms need no number
Rule impulse_rule(const problem::ImpulseLaw& law, int points);

}  // namespace fpkcheck::epc
