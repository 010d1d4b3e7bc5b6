#pragma once

#include <Eigen/Core>

namespace fpkcheck::epc::half_plane {

/// How many points a rule has along either coordinate, and on the wall.
struct QuadratureSize {
  int s, t, wall;
};

/// Points of a quadrature rule on the half-plane y >= 0: sum_i weight_i f(y_i, v_i). Q_n is a
/// polynomial of their coordinates s and t: (y, v) of the formulation moment, (rho, theta) of
/// polar.
struct Points {
  Eigen::VectorXd s, t;
  Eigen::VectorXd y, v;
  Eigen::VectorXd energy;  ///< h, by which the confinement goes
  Eigen::VectorXd weight;  ///< of dy dv

  /// So many of them, all of zeros.
  static Points zeros(Eigen::Index count);
  Eigen::Index size() const { return weight.size(); }
};

/// A rule of one variable.
struct Line {
  Eigen::VectorXd at, weight;
};

/// Gauss-Legendre rule on [a, b].
Line legendre_rule(int points, double a, double b);

}  // namespace fpkcheck::epc::half_plane
