#pragma once

#include <vector>

#include "epc/half_plane/points.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// The part of the half-plane y >= 0, or of what else the walls leave (problem/frame.hpp), below an
/// energy,
///
///     h(y, v) = v^2/2 + V(y) - min V <= level,     V(y) = U(y) - lambda E[Y] y,
///
/// where V is the potential of the restoring force and the mean of the impulses. Trajectories of
/// weak damping follow its contours, so that a stationary density is of a like size all along its
/// edge; a rectangle has far corners where a polynomial exponent may do anything. Below the energy
/// of a barrier the domain has several parts.
class EnergyDomain {
 public:
  /// @param level > 0
  EnergyDomain(const problem::Problem& problem, double level);

  double level() const { return level_; }
  /// h(y, v) above
  double energy(double y, double v) const { return v * v / 2 + (potential_(y) - least_); }
  bool contains(double y, double v) const {
    return y >= wall_low_ && y <= wall_high_ && energy(y, v) <= level_;
  }

  /// The intervals of y, increasing.
  const std::vector<problem::Swing>& parts() const { return parts_; }
  double y_low() const { return parts_.front().left; }  ///< the wall's where it lies inside
  double y_max() const { return parts_.back().right; }
  /// Densities on the domain begin at y_low(); at 0 where there is the paper's wall.
  double y_min() const { return at_equilibrium_ ? 0 : y_low(); }
  double v_max() const;
  /// Half-width in v at a given y: sqrt(2 (level - V(y) + min V)), 0 outside.
  double half_width(double y) const;

  /// Gauss-Legendre in phi and tau, y = a + b sin(phi), v = half_width(y) tau, on each part: the
  /// square root at the turning points of y is gone, so that smooth integrands converge
  /// geometrically. The coordinates s and t of the points are y and v.
  half_plane::Points rule(int y_points, int v_points) const;
  /// Gauss-Legendre on the incoming side of the wall on the left, -half_width < v < 0; no points
  /// where there is none, or it lies outside.
  half_plane::Line wall_rule(int points) const;
  /// Likewise on the incoming side of a wall on the right, 0 < v < half_width.
  half_plane::Line right_wall_rule(int points) const;

 private:
  struct Map {
    double centre, reach;  // y = centre + reach sin(phi)
    double first, last;    // phi
  };
  void part_from_the_wall_at_0(const problem::Problem& problem);
  void parts_between(const problem::Problem& problem);
  double turning_point(double from, double towards) const;
  double continued(double wall, double far) const;
  Map map_of(const problem::Swing& part) const;

  numerics::Polynomial potential_;  // V
  double level_;
  double least_ = 0;  // min V
  double wall_low_, wall_high_;
  std::vector<problem::Swing> parts_;
  bool at_equilibrium_;  // the paper's: one wall at y = 0, to which the spring alone drives
  double minimum_ = 0;   // then: where V is least on y >= 0
};

}  // namespace fpkcheck::epc::moment
