#pragma once

#include <optional>
#include <vector>

#include "epc/half_plane/half_plane_basis.hpp"
#include "numerics/polynomials/polynomial.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/undamped_orbits.hpp"
#include "problem/walls.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Set of the states (y, v) below an energy level in the half-plane y >= 0, or in the region
/// between other walls (problem/walls.hpp),
///
///     h(y, v) = v^2/2 + V(y) - min V <= level,     V(y) = U(y) - lambda E[Y] y.
///
/// The potential V is that of the restoring force and of the mean of the impulses. Under weak
/// damping a stationary density is nearly constant along a contour of constant energy, such as the
/// edge of the domain. A rectangular domain would be unsuitable, since no moment equation controls
/// a polynomial exponent in the far corners of a rectangle. If its energy level is below a
/// potential barrier, the domain has several parts.
class EnergySublevelSet {
 public:
  /// @param level energy on the edge of the domain, > 0
  EnergySublevelSet(const problem::Problem& problem, double level);

  double energy_level() const { return level_; }
  /// Energy h(y, v) of a state of the oscillator, relative to the minimum of the potential V.
  double energy(double y, double v) const {
    return v * v / 2 + (potential_(y) - lowest_potential_);
  }
  bool contains(double y, double v) const {
    return y >= wall_low_ && y <= wall_high_ && energy(y, v) <= level_;
  }

  const std::vector<problem::HalfCycle>& y_intervals() const { return parts_; }
  /// Smallest displacement y of the domain: the left wall if this wall cuts the domain.
  double y_low() const { return parts_.front().left; }
  double y_max() const { return parts_.back().right; }
  double v_max() const;
  /// Half-width of the domain in the velocity v at a displacement y: sqrt(2 (level - V(y) + min V))
  /// with the potential V, or 0 outside of the domain.
  double velocity_half_width(double y) const;

  /// Returns Gauss-Legendre points in phi and tau on each part of the domain, where y = a + b
  /// sin(phi) and v = tau velocity_half_width(y). The substitution y = a + b sin(phi) removes the
  /// square-root singularity of the half-width in v at the turning points. With the substitution y
  /// = a + b sin(phi) the Gauss-Legendre quadrature of smooth functions converges geometrically.
  /// Quadrature panels end at the values of y and of v at which a formula has a kink.
  half_plane::QuadraturePoints quadrature_points(int y_points, int v_points) const;
  /// Gauss-Legendre rule in the velocity v before an impact on the left wall, -velocity_half_width
  /// < v < 0, with panels that end at the kinks of the restitution coefficient. If no left wall
  /// cuts the domain, the quadrature rule on the left wall is empty.
  numerics::QuadratureRule left_wall_quadrature_rule(int point_count) const;
  /// Gauss-Legendre rule in the velocity v before an impact on the right wall, 0 < v <
  /// velocity_half_width. If no right wall cuts the domain, the rule on the right wall is empty.
  numerics::QuadratureRule right_wall_quadrature_rule(int point_count) const;

 private:
  // Map y = centre + half_length sin(phi) from an angle phi to one part of the domain.
  struct SineMap {
    double centre, half_length;
    double first, last;  // limits of the angle phi
  };
  double turning_point(double from, double towards) const;
  double turning_point_behind_wall(double wall, double far) const;
  SineMap sine_map_of_half_cycle(const problem::HalfCycle& part) const;

  problem::EffectivePotential potential_;  // potential V
  double level_;
  double lowest_potential_;
  std::optional<problem::Wall> left_wall_, right_wall_;
  double wall_low_, wall_high_;
  std::vector<problem::HalfCycle> parts_;
  std::vector<double> y_kinks_, v_kinks_;  // kinks of the formulas in the domain
  // Whether the quadrature in v has more points near v = 0, where smoothed dry friction such as
  // tanh(v/eps) is steep. If the force has a kink at v = 0, quadrature panels end at v = 0 instead.
  bool dense_at_rest_ = false;
};

}  // namespace fpkcheck::epc::moment
