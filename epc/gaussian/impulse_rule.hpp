#pragma once

#include "epc/gaussian/rules.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// E[g(Y)] for a smooth g, by the Gauss rule of the law about its mean: Hermite for gaussian,
/// Laguerre on either side for laplace, Legendre for uniform; the atoms themselves for two_point;
/// for a law of another kind by piecewise_impulse_rule.
/// @param points of the rule, on each side for laplace; neither atoms nor pieces need a number
Rule impulse_rule(const problem::ImpulseLaw& law, int points);

/// The same for any law: its atoms, and Gauss-Legendre panels of its density that end where the
/// density is not smooth.
Rule piecewise_impulse_rule(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::epc::gaussian
