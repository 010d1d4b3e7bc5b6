#pragma once

#include "epc/gaussian/quadrature_rules.hpp"

namespace fpkcheck::problem {
class ImpulseLaw;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Quadrature rule for the mean E[g(Y)] of a smooth function g of the impulse. The rule is the
/// Gauss rule of the law about its mean: Gauss-Hermite for the law gaussian, Gauss-Laguerre on
/// either side of the mean for laplace, Gauss-Laguerre for exponential, Gauss-Legendre for uniform.
/// The rule of two_point consists of the atoms. Any other law has
/// piecewise_impulse_quadrature_rule().
/// @param points number of points, for laplace on each side; unused for two_point and for
///        piecewise_impulse_quadrature_rule()
QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points);

/// Quadrature rule for E[g(Y)] for any law of the impulse Y: the atoms of the law, and
/// Gauss-Legendre panels for the density of the law. Panels end at points where this density is not
/// smooth.
QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law);

}  // namespace fpkcheck::epc::gaussian
