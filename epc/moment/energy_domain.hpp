#pragma once

#include <vector>

#include "epc/half_plane/quadrature_points.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Part of the half-plane y >= 0, or of the region between other walls (problem/frame.hpp), below
/// an energy,
///
///     h(y, v) = v^2/2 + V(y) - min V <= level,     V(y) = U(y) - lambda E[Y] y,
///
/// where V is the potential of the restoring force and of the mean of the impulses. Trajectories
/// under weak damping follow the energy contours: a stationary density is nearly constant along the
/// edge of the domain. In the far corners of a rectangle a polynomial exponent is uncontrolled.
/// Below the energy of a barrier the domain has several parts.
class EnergyDomain {
 public:
  /// @param level > 0
  EnergyDomain(const problem::Problem& problem, double level);

  double level() const { return level_; }
  /// h(y, v) above
  double energy(double y, double v) const {
    return v * v / 2 + (potential_(y) - lowest_potential_);
  }
  bool contains(double y, double v) const {
    return y >= wall_low_ && y <= wall_high_ && energy(y, v) <= level_;
  }

  /// Intervals of y in increasing order.
  const std::vector<problem::HalfCycle>& parts() const { return parts_; }
  double y_low() const { return parts_.front().left; }  ///< position of a wall inside the domain
  double y_max() const { return parts_.back().right; }
  /// Lower end in y of densities on the domain: y_low(), or 0 in the paper's class.
  double y_min() const { return at_equilibrium_ ? 0 : y_low(); }
  double v_max() const;
  /// Half-width in v at y: sqrt(2 (level - V(y) + min V)), 0 outside.
  double half_width(double y) const;

  /// Gauss-Legendre points in phi and tau, y = a + b sin(phi), v = half_width(y) tau, on each part.
  /// The map removes the square root at the turning points of y: smooth integrands converge
  /// geometrically. The coordinates s and t of the points are y and v.
  half_plane::QuadraturePoints quadrature_points(int y_points, int v_points) const;
  /// Gauss-Legendre points on the left wall before impact, -half_width < v < 0. Empty without a
  /// left wall inside the domain.
  half_plane::QuadratureRule wall_rule(int points) const;
  /// Likewise on the right wall before impact, 0 < v < half_width.
  half_plane::QuadratureRule right_wall_rule(int points) const;

 private:
  struct SineMap {
    double centre, half_length;  // y = centre + half_length sin(phi)
    double first, last;          // limits of phi
  };
  void add_part_at_wall(const problem::Problem& problem);
  void add_parts_between_walls(const problem::Problem& problem);
  double turning_point(double from, double towards) const;
  double continued_turning_point(double wall, double far) const;
  SineMap sine_map_of(const problem::HalfCycle& part) const;

  numerics::Polynomial potential_;  // V
  double level_;
  double lowest_potential_ = 0;  // min V
  double wall_low_, wall_high_;
  std::vector<problem::HalfCycle> parts_;
  bool at_equilibrium_;  // the paper's class: one wall at y = 0, the equilibrium of the spring
  double minimum_ = 0;   // in the paper's class: minimiser of V on y >= 0
};

}  // namespace fpkcheck::epc::moment
