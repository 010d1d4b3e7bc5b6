#pragma once

#include <vector>

namespace fpkcheck::epc::gaussian {

/// Quadrature rule in one variable: nodes and weights.
struct QuadratureRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// Quadrature rule for E[g(u)] with a standard normal variable u (Gauss-Hermite). The rule is exact
/// for polynomials g up to the given degree.
QuadratureRule normal_quadrature_rule(int degree);

/// Quadrature rule for E[sgn(u) g(u)] with a standard normal variable u. The rule is exact for
/// polynomials g up to the given degree; some weights are negative.
QuadratureRule sign_weighted_normal_rule(int degree);

/// Quadrature rule for E[|u| g(u)] with a standard normal variable u. The rule is exact for
/// polynomials g up to the given degree.
QuadratureRule absolute_weighted_normal_rule(int degree);

/// Quadrature rule for int_0^inf g(t) exp(-t) dt (Gauss-Laguerre). The rule is exact for
/// polynomials g up to the given degree.
QuadratureRule exponential_quadrature_rule(int degree);

/// Quadrature rule for the average of g over (-1, 1) (Gauss-Legendre). The rule is exact for
/// polynomials g up to the given degree.
QuadratureRule uniform_quadrature_rule(int degree);

}  // namespace fpkcheck::epc::gaussian
