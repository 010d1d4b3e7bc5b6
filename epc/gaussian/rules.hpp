#pragma once

#include <vector>

namespace fpkcheck::epc::gaussian {

/// Quadrature rule: nodes and weights. Below, u is a standard normal variable.
struct Rule {
  std::vector<double> nodes;
  std::vector<double> weights;
};

/// E[g(u)], exact for polynomials g up to the given degree (Gauss-Hermite).
Rule normal_rule(int degree);

/// E[sgn(u) g(u)], exact for polynomials g up to the given degree; some weights are negative.
Rule sign_rule(int degree);

/// E[|u| g(u)], exact for polynomials g up to the given degree.
Rule absolute_rule(int degree);

/// int_0^inf g(t) exp(-t) dt, exact for polynomials g up to the given degree (Gauss-Laguerre).
Rule exponential_rule(int degree);

/// The average of g over (-1, 1), exact for polynomials g up to the given degree (Gauss-Legendre).
Rule uniform_rule(int degree);

}  // namespace fpkcheck::epc::gaussian
