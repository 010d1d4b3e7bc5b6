#pragma once

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// The expectations under a density that enter the balance of power.
struct EnergyTerms {
  double mean_velocity;            ///< E[y']
  double mean_square_velocity;     ///< E[y'^2]
  double impact_energy_flux;       ///< int_{v<0} |v|^3 p(a, v) dv at a left wall a
  double right_energy_flux = 0;    ///< int_{v>0} v^3 p(b, v) dv at a right wall b
  double mean_damping_power = {};  ///< E[y' f(y, y')]; not used if f = c y'
};

/// The two sides of the balance of power: mean energy input and dissipated energy, per unit time.
/// At any time and for each equation, input minus dissipated is the time derivative of the mean
/// energy E[v^2]/2 + E[U(y)], where U is the potential of System.
struct PowerBalance {
  double input;  ///< D + lambda E[Y^2]/2 + lambda E[Y] E[v]
  /// E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv, likewise at b; for kappa see energy_residual().
  double dissipated;
};
PowerBalance power_balance(const Problem& problem, Impact impact, const EnergyTerms& terms);

/// Residual of the stationary balance of power, divided by the input. The balance is
///
///     D + lambda E[Y^2]/2 + lambda E[Y] E[v] = E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv + ..,
///
/// with kappa = (1-r^2)/2, or kappa = 1-r for Impact::delta. The residual is zero for the exact
/// stationary density of each of the equations `white`, `km4` and `kf`, which agree in E[Y] and
/// E[Y^2]: the energy is quadratic in v, so that no higher moments of Y enter.
double energy_residual(const Problem& problem, Impact impact, const EnergyTerms& terms);

/// The virial balance and the momentum balance follow from Dynkin's formula for f = y v and f = v
/// under any stationary density on the half-plane,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// where g is the restoring force of System. The balances also use E[v] = 0 and E[y v] = 0, which
/// follow from Dynkin's formula for f = y and f = y^2/2, since neither impulses nor impacts change
/// y. In the same way E[c(y) v] = E[y c(y) v] = 0 for any c(y). The balances hold in wall
/// coordinates (problem/walls.hpp), with a left wall at 0. A right wall at b, damping c_vv v^3 and
/// atoms in contact add terms. E[g] includes the atoms.
///
/// Both functions f are linear in v, so that of the moments of Y only E[Y] enters. The balances
/// therefore hold for the equations `kf`, `km4`, `km4_pade` and `white`. The balances also hold for
/// both impact conditions, for these reasons: at the wall y v = 0; and `delta`, which replaces the
/// flux f(w) of impact speeds w by f(w) + (1-r) d(w f)/dw, returns the momentum r int w f dw (by
/// integration by parts), which is also the momentum that `map` returns. Only the balance of power,
/// quadratic in v, distinguishes the two impact conditions.

/// The two sides of a balance equation: left = right for the exact stationary density.
struct BalanceEquation {
  double left;
  double right;
  double scale;  ///< reference magnitude of the relative residual

  double difference() const { return left - right; }
  double residual() const { return difference() / scale; }
};

struct VirialTerms {
  double mean_displacement;          ///< E[y]
  double mean_square_velocity;       ///< E[v^2]
  double mean_virial;                ///< E[y g(y)]
  double right_momentum = 0;         ///< int_{u>0} u^2 p(b,u) du
  double mean_y_cubed_velocity = 0;  ///< E[y v^3]; used where c_vv is not 0
};

/// The virial balance
///
///     E[v^2] = E[y g(y)] + c_vv E[y v^3] - lambda E[Y] E[y] + (1 + r_b) b int u^2 p(b,u) du,
///
/// with a residual relative to E[v^2].
BalanceEquation virial_balance(const Problem& problem, const VirialTerms& terms);

struct MomentumTerms {
  double mean_force;          ///< E[g(y)]
  double impact_momentum;     ///< int_{u>0} u^2 p(0,-u) du, the incoming momentum per unit time
  double right_momentum = 0;  ///< int_{u>0} u^2 p(b,u) du
  double mean_cubed_velocity = 0;  ///< E[v^3]; used where c_vv is not 0
  /// Mean contact force of the mass at rest plus momentum per unit time of the rebounds that
  /// impulses towards the wall cause: g(0) P0 + (1 + r) lambda P0 E[Y^-] at the left wall.
  double contact_momentum_rate = 0;
  /// E[|g(y)|], the scale of the residual for forces of both signs. In potential wells far from a
  /// wall, both the mean force and the momentum from the wall are nearly 0, so that neither can be
  /// the scale.
  double mean_absolute_force = 0;
};

/// The momentum balance
///
///     E[g(y)] + c_vv E[v^3] = lambda E[Y] + (1 + r) int u^2 p(0,-u) du
///                             - (1 + r_b) int u^2 p(b,u) du + contact term,
///
/// with a residual relative to the larger of two contributions: that of the spring and that of the
/// walls. Either contribution alone may be small: for a mean impulse towards the wall the
/// contribution of the spring, for a mean impulse away from the wall that of the wall. In a
/// symmetric well without a wall, both sides are 0 and the residual is meaningless; use
/// difference().
BalanceEquation momentum_balance(const Problem& problem, const MomentumTerms& terms);

}  // namespace fpkcheck::problem
