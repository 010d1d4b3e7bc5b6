#pragma once

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

/// Number of quadrature points in each coordinate and on the wall.
struct QuadratureSize {
  int s, t, wall;
};

/// Quadrature rule on the half-plane y >= 0: sum_i weight_i f(y_i, v_i). Q_n is a polynomial of the
/// coordinates s and t: (y, v) for the formulation moment, (rho, theta) for polar, (rho, v) for
/// contact.
struct QuadraturePoints {
  Eigen::VectorXd s, t;
  Eigen::VectorXd y, v;
  Eigen::VectorXd energy;  ///< h, argument of the confinement
  Eigen::VectorXd weight;  ///< for dy dv

  /// A rule of `count` points with all values zero.
  static QuadraturePoints zeros(Eigen::Index count);
  Eigen::Index size() const { return weight.size(); }
};

/// Quadrature rule in one variable.
struct QuadratureRule {
  Eigen::VectorXd at, weight;
};

/// Gauss-Legendre rule on [a, b].
QuadratureRule legendre_rule(int points, double a, double b);

}  // namespace fpkcheck::epc::half_plane
