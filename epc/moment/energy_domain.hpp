#pragma once

#include "epc/half_plane/points.hpp"
#include "problem/polynomial.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// The part of the half-plane y >= 0 below an energy,
///
///     h(y, v) = v^2/2 + V(y) - min V <= level,     V(y) = U(y) - lambda E[Y] y,
///
/// where V is the potential of the restoring force and the mean of the impulses. Trajectories of
/// weak damping follow its contours, so that a stationary density is of a like size all along its
/// edge; a rectangle has far corners where a polynomial exponent may do anything.
class EnergyDomain {
 public:
  /// @param level > 0
  EnergyDomain(const problem::Problem& problem, double level);

  double level() const { return level_; }
  /// h(y, v) above
  double energy(double y, double v) const { return v * v / 2 + (potential_(y) - least_); }
  bool contains(double y, double v) const { return y >= 0 && energy(y, v) <= level_; }

  double y_low() const { return y_low_; }  ///< 0 where the wall lies inside
  double y_max() const { return y_high_; }
  double v_max() const;
  /// Half-width in v at a given y: sqrt(2 (level - V(y) + min V)), 0 outside.
  double half_width(double y) const;

  /// Gauss-Legendre in phi and tau, y = a + b sin(phi), v = half_width(y) tau: the square root at
  /// the turning points of y is gone, so that smooth integrands converge geometrically. The
  /// coordinates s and t of the points are y and v.
  half_plane::Points rule(int y_points, int v_points) const;
  /// Gauss-Legendre on the wall's incoming side, y = 0, -half_width(0) < v < 0; no points where the
  /// wall lies outside.
  half_plane::Line wall_rule(int points) const;

 private:
  double turning_point(double from, double towards) const;

  problem::Polynomial potential_;  // V
  double level_;
  double minimum_;  // where V is least on y >= 0
  double least_;    // min V
  double y_low_ = 0, y_high_ = 0;
};

}  // namespace fpkcheck::epc::moment
