#pragma once

#include <Eigen/Core>
#include <cmath>

#include "backward/generator/impact_basis.hpp"

namespace fpkcheck::backward {

/// Spline coefficients of x^n, n <= degree: means of the products of n inner knots of a function.
inline Eigen::VectorXd power_coefficients(const numerics::SplineBasis& basis, int n) {
  const int p = basis.degree();
  Eigen::VectorXd c(basis.size());
  for (int i = 0; i < basis.size(); ++i) {
    Eigen::VectorXd symmetric = Eigen::VectorXd::Zero(n + 1);  // elementary symmetric sums
    symmetric(0) = 1;
    for (int a = 1; a <= p; ++a) {
      for (int k = n; k > 0; --k) symmetric(k) += basis.spline_knot(i + a) * symmetric(k - 1);
    }
    double choose = 1;
    for (int k = 1; k <= n; ++k) choose *= static_cast<double>(p - n + k) / k;
    c(i) = symmetric(n) / choose;
  }
  return c;
}

/// Spline coefficients of v^n on [-u_max, r u_max].
inline Eigen::VectorXd power_coefficients(const ImpactSplineBasis& basis, int n) {
  const Eigen::VectorXd speed = power_coefficients(basis.speed_basis(), n);
  Eigen::VectorXd c(basis.size());
  for (int h = 0; h < speed.size(); ++h) {
    c(basis.outgoing_basis_index(h)) = speed(h) * std::pow(basis.restitution(), n);
    c(basis.incoming_basis_index(h)) = speed(h) * std::pow(-1.0, n);
  }
  return c;
}

/// sum_b c_b B_b(v), constant beyond the ends.
inline double spline_value(const ImpactSplineBasis& basis, const Eigen::VectorXd& c, double v) {
  const numerics::SplineBasis& speeds = basis.speed_basis();
  const double u = std::min(v < 0 ? -v : v / basis.restitution(), speeds.end());
  const int span = speeds.knot_span_containing(u);
  const Eigen::MatrixXd at = speeds.basis_derivatives(u, span, 0);
  double sum = 0;
  for (int l = 0; l <= speeds.degree(); ++l) {
    sum += at(0, l) *
           c(v < 0 ? basis.incoming_basis_index(span + l) : basis.outgoing_basis_index(span + l));
  }
  return sum;
}

}  // namespace fpkcheck::backward
