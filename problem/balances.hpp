#pragma once

#include "problem/model.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

struct PowerBalanceTerms {
  double mean_velocity;
  double mean_square_velocity;
  double impact_energy_flux;       ///< int_{v<0} |v|^3 p(a, v) dv at a left wall a
  double right_energy_flux = 0;    ///< int_{v>0} v^3 p(b, v) dv at a right wall b
  double mean_damping_power = {};  ///< E[y' f(y, y')]; not used if f = c y'
};

/// The two sides of the balance of power: mean energy input and dissipated energy per unit time.
/// Input minus dissipation is the time derivative of the mean energy E[v^2]/2 + E[U(y)], where U is
/// the potential of System.
struct PowerBalance {
  double input;  ///< D + lambda E[Y^2]/2 + lambda E[Y] E[v]
  /// E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv + kappa int_{v>0} v^3 p(b,v) dv, with the kappa of
  /// energy_residual().
  double dissipated;
};
PowerBalance power_balance(const Problem& problem, ImpactCondition impact,
                           const PowerBalanceTerms& terms);

/// Returns the input minus the dissipation in the stationary balance of power, divided by the
/// input. The balance of power is
///
///     D + lambda E[Y^2]/2 + lambda E[Y] E[v] = E[v f] + kappa int_{v<0} |v|^3 p(a,v) dv + ..,
///
/// where kappa = (1-r^2)/2 is the loss at an impact, or kappa = 1-r for ImpactCondition::delta. The
/// residual is zero for the exact stationary density of each of the equations `white`, `km4` and
/// `kf`. The energy is quadratic in v, and therefore only the moments E[Y] and E[Y^2] enter the
/// balance.
double energy_residual(const Problem& problem, ImpactCondition impact,
                       const PowerBalanceTerms& terms);

/// The virial balance and the momentum balance follow from Dynkin's formula for f = y v and f = v
/// under any stationary density on the half-plane y >= 0,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// where g is the restoring force of System. Dynkin's formula for f = y and f = y^2/2 gives E[v] =
/// 0 and E[y v] = 0, since neither impulses nor impacts change y. For any function c(y), E[c(y) v]
/// = E[y c(y) v] = 0 for the same reason. The virial and momentum balances hold in wall coordinates
/// (problem/walls.hpp), with a left wall at 0. A right wall at b, damping c_vv v^3 and rest atoms
/// add terms to these balances. The expectation E[g] includes the rest atoms.
///
/// The functions y v and v are linear in v, so that E[Y] is the only moment of Y in the virial and
/// momentum balances. These balances therefore hold for the equations `kf`, `km4`, `km4_pade` and
/// `white`. They also hold for the impact conditions `map` and `delta`: y v = 0 at the wall, and
/// both conditions return the momentum r int w f dw, where f(w) is the flux of impact speeds w. The
/// condition `delta` replaces f by f + (1-r) d(w f)/dw; integration by parts gives the returned
/// momentum. Only the balance of power, quadratic in v, distinguishes `map` from `delta`.

/// The two sides of a balance equation, which are equal for the exact stationary density.
struct BalanceEquation {
  double left;
  double right;
  double scale;  ///< magnitude by which the residual is divided

  double difference() const { return left - right; }
  double residual() const { return difference() / scale; }
};

struct VirialBalanceTerms {
  double mean_displacement;
  double mean_square_velocity;
  /// Mean virial E[y g(y)], or E[y (f + g)] for the formula of a force.
  double mean_virial;
  double right_momentum = 0;         ///< momentum rate int_{u>0} u^2 p(b,u) du at wall b
  double mean_y_cubed_velocity = 0;  ///< E[y v^3]; used where c_vv is not 0
};

/// Returns the two sides and the scale E[v^2] of the virial balance
///
///     E[v^2] = E[y g(y)] + c_vv E[y v^3] - lambda E[Y] E[y] + (1 + r_b) b int u^2 p(b,u) du.
BalanceEquation virial_balance(const Problem& problem, const VirialBalanceTerms& terms);

struct MomentumBalanceTerms {
  /// Mean force E[g(y)], or E[f + g] for the formula of a force.
  double mean_force;
  double impact_momentum;     ///< int_{u>0} u^2 p(0,-u) du, the incoming momentum per unit time
  double right_momentum = 0;  ///< momentum rate int_{u>0} u^2 p(b,u) du at wall b
  double mean_cubed_velocity = 0;  ///< E[v^3]; used where c_vv is not 0
  /// Momentum per unit time from the contact force on the mass at rest and from rebounds after
  /// impulses towards the wall. At the left wall, with rest probability P0, this rate is g(0) P0 +
  /// (1 + r) lambda P0 E[Y^-].
  double contact_momentum_rate = 0;
  /// E[|g(y)|], the scale of the momentum balance in wells far from a wall, where the mean force
  /// and the momentum from the wall are nearly 0.
  double mean_absolute_force = 0;
};

/// Returns the two sides and the scale of the momentum balance
///
///     E[g(y)] + c_vv E[v^3] = lambda E[Y] + (1 + r) int u^2 p(0,-u) du
///                             - (1 + r_b) int u^2 p(b,u) du + contact term.
///
/// The scale is the largest of three terms: the contribution of the spring, the contribution of the
/// walls, and E[|g(y)|]. In a symmetric well without a wall both sides of the balance are 0. If
/// mean_absolute_force is then unknown, use difference() instead of residual().
BalanceEquation momentum_balance(const Problem& problem, const MomentumBalanceTerms& terms);

}  // namespace fpkcheck::problem
