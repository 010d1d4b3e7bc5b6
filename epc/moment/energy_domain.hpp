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

/// Set of the states below an energy in the half-plane y >= 0, or in the region between other walls
/// (problem/walls.hpp),
///
///     h(y, v) = v^2/2 + V(y) - min V <= level,     V(y) = U(y) - lambda E[Y] y.
///
/// Here V denotes the potential of the restoring force and of the mean of the impulses. Under weak
/// damping a stationary density is nearly constant along the edge of the domain. A rectangle would
/// be unsuitable, since no equation controls a polynomial exponent in the far corners of a
/// rectangle. Below the energy of a potential barrier the domain has several parts.
class EnergySublevelSet {
 public:
  /// @param level energy of the edge of the domain, > 0
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
  /// Lower end of the domain in y: the left wall if this wall cuts the domain.
  double y_low() const { return parts_.front().left; }
  double y_max() const { return parts_.back().right; }
  double v_max() const;
  /// Half-width of the domain in v at a displacement y: sqrt(2 (level - V(y) + min V)), or 0
  /// outside of the domain.
  double velocity_half_width(double y) const;

  /// Returns Gauss-Legendre points in phi and tau on each part of the domain, where y = a + b
  /// sin(phi) and v = velocity_half_width(y) tau. The substitution y = a + b sin(phi) removes the
  /// square-root singularity at the turning points. The Gauss-Legendre quadrature of smooth
  /// integrands therefore converges geometrically. Panels end at the values of y and of v at which
  /// a formula of the problem has a kink.
  half_plane::QuadraturePoints quadrature_points(int y_points, int v_points) const;
  /// Gauss-Legendre rule in v on the left wall before an impact, -velocity_half_width < v < 0, with
  /// panels that end at the kinks of the restitution coefficient. If no left wall cuts the domain,
  /// this quadrature rule is empty.
  numerics::QuadratureRule left_wall_quadrature_rule(int point_count) const;
  /// Gauss-Legendre rule in v on the right wall before an impact, 0 < v < velocity_half_width. If
  /// no right wall cuts the domain, this quadrature rule is empty.
  numerics::QuadratureRule right_wall_quadrature_rule(int point_count) const;

 private:
  // Map y = centre + half_length sin(phi) of one part of the domain.
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
  // Whether the quadrature has more points near v = 0, where smoothed dry friction such as
  // tanh(v/eps) is steep. A kink of the force at v = 0 is an end of quadrature panels instead.
  bool dense_at_rest_ = false;
};

}  // namespace fpkcheck::epc::moment
