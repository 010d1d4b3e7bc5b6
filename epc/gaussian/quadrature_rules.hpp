#pragma once

#include <vector>

namespace fpkcheck::epc::gaussian {

/// Quadrature rule: nodes and weights. Below, u is a standard normal variable.
struct QuadratureRule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// E[g(u)], exact for polynomials g up to the given degree (Gauss-Hermite).
QuadratureRule normal_rule(int degree);

/// E[sgn(u) g(u)], exact for polynomials g up to the given degree; some weights are negative.
QuadratureRule sign_rule(int degree);

/// E[|u| g(u)], exact for polynomials g up to the given degree.
QuadratureRule absolute_rule(int degree);

/// int_0^inf g(t) exp(-t) dt, exact for polynomials g up to the given degree (Gauss-Laguerre).
QuadratureRule exponential_rule(int degree);

/// The average of g over (-1, 1), exact for polynomials g up to the given degree (Gauss-Legendre).
QuadratureRule uniform_rule(int degree);

}  // namespace fpkcheck::epc::gaussian
