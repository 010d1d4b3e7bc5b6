#pragma once

#include <vector>

#include <Eigen/Dense>

#include "epc/moment/confinement.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::polar {

/// Amplitude and phase of the half-plane y >= 0,
///
///     rho cos(theta) = w(y) = sqrt(2 V(y)),   rho sin(theta) = v,   -pi/2 <= theta <= pi/2,
///     V(y) = K y^2/2 + mu y^4/4,              h = rho^2/2 = v^2/2 + V(y).
///
/// The oscillator without damping keeps rho and turns clockwise; an impact takes it from theta =
/// -pi/2 to pi/2 and multiplies rho by r. The density jumps at the origin, p(0,0+) r^2 = p(0,0-),
/// and fans out from there: functions of theta do so too, those of y and v cannot.
///
/// K is the stiffness k, so that h is the energy; only where k is so small that w(y) would be
/// nearly y^2, K is a part of the linearised stiffness. The mean of the impulses is no part of V.
class Coordinates {
 public:
  explicit Coordinates(const problem::Problem& problem);

  double w(double y) const;
  /// dw/dy > 0
  double slope(double y) const;
  /// y of w(y), the inverse.
  double y(double w) const;
  double rho(double y, double v) const;
  double theta(double y, double v) const;
  /// (k y + mu y^3) / w(y): the slope of w where K = k.
  double force_by_w(double y) const;

 private:
  double stiffness_, cubic_, own_stiffness_;
};

/// Points of a rule on 0 <= rho <= rho_max in the half-plane.
struct Points {
  Eigen::VectorXd rho, theta, y, v;
  Eigen::VectorXd weight;  ///< of dy dv
};

/// How many points a rule has: in rho, between one break and the next as many more as to keep its
/// ends resolved, and in theta.
struct QuadratureSize {
  int rho, theta;
};

/// Gauss-Legendre in rho and theta: what fans out from the origin is smooth in them.
/// @param breaks increasing amplitudes between 0 and rho_max at which the integrand may change
///   abruptly on the wall; panels end there
Points rule(const Coordinates& coordinates, double rho_max, const std::vector<double>& breaks,
            const QuadratureSize& size);

/// h / level -> the confinement's term at amplitude rho.
inline double confined(const moment::Confinement& confinement, double rho) {
  return confinement(rho * rho / 2);
}

}  // namespace fpkcheck::epc::polar
