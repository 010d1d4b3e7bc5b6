#pragma once

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

/// Numbers of quadrature points in the coordinates s and t, and on the wall.
struct QuadratureSize {
  int s, t, wall;
};

/// Quadrature rule on the half-plane y >= 0, which approximates an integral of f by
/// sum_i weight_i f(y_i, v_i). Q_n is a polynomial of the coordinates s and t, which are (y, v) for
/// the formulation moment, (rho, theta) for polar, and (rho, v) for contact.
struct QuadraturePoints {
  Eigen::VectorXd s, t;
  Eigen::VectorXd y, v;
  Eigen::VectorXd energy;  ///< energy h, the argument of the confinement
  Eigen::VectorXd weight;  ///< quadrature weights for dy dv

  /// A rule of `count` points whose coordinates, energies and weights are all 0.
  static QuadraturePoints zeros(Eigen::Index count);
  Eigen::Index size() const { return weight.size(); }
};

/// Quadrature rule in one variable: nodes and weights.
struct QuadratureRule {
  Eigen::VectorXd nodes, weight;
};

/// Gauss-Legendre rule on [from, to].
QuadratureRule gauss_legendre_rule(int point_count, double from, double to);

}  // namespace fpkcheck::epc::half_plane
