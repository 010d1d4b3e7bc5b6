#pragma once

#include "epc/gaussian/quadrature_rules.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Quadrature rule for E[g(Y)], g smooth: the Gauss rule of the law about its mean. Hermite for
/// gaussian, Laguerre on either side for laplace, Laguerre for exponential, Legendre for uniform,
/// the atoms for two_point, and piecewise_impulse_rule for any other law.
/// @param points number of points, on each side for laplace; unused for atoms and piecewise rules
QuadratureRule impulse_rule(const problem::ImpulseLaw& law, int points);

/// Quadrature rule for E[g(Y)] for any law: its atoms, and Gauss-Legendre panels on its density.
/// The panels end where the density is not smooth.
QuadratureRule piecewise_impulse_rule(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::epc::gaussian
