#pragma once

#include "problem/equation_and_impact_condition.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::problem {

/// Means of a density, and energy losses at the walls, that enter the stationary balance of power.
struct PowerBalanceTerms {
  double mean_velocity;
  double mean_square_velocity;
  /// Energy lost per unit time by impacts at the left wall and at the right wall
  /// (impact_energy_loss_rate()).
  double left_impact_loss = 0, right_impact_loss = 0;
  double mean_damping_power = {};         ///< E[y' f(y, y')]; not used if f = c y'
  double mean_square_noise_factor = 1;    ///< E[G] of multiplicative noise with G = g^2
  double mean_square_impulse_factor = 1;  ///< E[b^2] of parametric impulses with the factor b
};

/// Returns the energy lost in an impact at the speed u with restitution coefficient r, which is (1
/// - r^2) u^2 / 2, or (1 - r) u^2 for ImpactCondition::delta.
double energy_loss_at_impact(const Wall& wall, ImpactCondition condition, double impact_speed);
/// Returns the change (1 + r) u of the momentum in an impact at the speed u, with restitution
/// coefficient r.
double momentum_change_at_impact(const Wall& wall, double impact_speed);

/// Returns the energy lost per unit time at a wall of constant restitution coefficient r; 0 without
/// a wall. With the joint density p(y, v) and a wall at y = a, the energy loss rate is
///
///     kappa int |v|^3 p(a,v) dv,    kappa = (1-r^2)/2, or kappa = 1-r for ImpactCondition::delta.
///
/// @param cubed_speed_integral integral int |v|^3 p(a,v) dv over the velocities v into the wall
double impact_energy_loss_rate(const std::optional<Wall>& wall, ImpactCondition condition,
                               double cubed_speed_integral);

/// The two sides of the balance of power: mean energy input and dissipated energy per unit time.
/// Energy input minus dissipated energy is the time derivative of the mean energy E[v^2]/2 +
/// E[U(y)], where U is the potential of System.
struct PowerBalance {
  double input;       ///< D E[G] + lambda E[Y^2] E[b^2]/2 + lambda E[Y] E[v]
  double dissipated;  ///< E[v f] + energy lost in impacts
};
/// Returns the energy input and the dissipated energy per unit time for the means of a density.
PowerBalance power_balance(const Problem& problem, const PowerBalanceTerms& terms);

/// Returns the residual of the stationary balance of power, i.e. energy input minus dissipated
/// energy, divided by the energy input. The balance of power of the stationary density is
///
///     D E[G] + lambda E[Y^2] E[b^2]/2 + lambda E[Y] E[v]
///         = E[v f] + int (1-r^2) |v|^3/2 p(a,v) dv,
///
/// with the impact integral over every wall and the damping force f of the equation in Ito's sense.
/// The residual of the balance of power is zero for the exact stationary density of each of the
/// density equations `white`, `km4` and `kf`. The energy is quadratic in the velocity, and
/// therefore only the moments E[Y] and E[Y^2] of the amplitude Y enter the balance of power.
double power_balance_residual(const Problem& problem, const PowerBalanceTerms& terms);

/// The virial balance and the momentum balance follow from Dynkin's formula for f = y v and f = v
/// under any stationary density on the half-plane y >= 0,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// where p is the joint density and g the restoring force of the oscillator (System). Dynkin's
/// formula for f = y and f = y^2/2 gives E[v] = 0 and E[y v] = 0, since neither impulses nor
/// impacts change y. For any function c(y), the means E[c(y) v] and E[y c(y) v] are 0, as
/// stationary means of time derivatives of functions of y. The virial and momentum balances hold in
/// wall coordinates (problem/walls.hpp), with a left wall at 0. A right wall at b, damping c_vv v^3
/// and atoms at rest add terms to the virial and momentum balances. The expectation E[g] of the
/// restoring force includes the atoms at rest.
///
/// The functions f = y v and f = v in Dynkin's formula are linear in v, so that E[Y] is the only
/// moment of Y in the virial and momentum balances. The virial and momentum balances therefore hold
/// for the equations `kf`, `km4`, `km4_pade` and `white`, and also for the impact conditions `map`
/// and `delta`: y v = 0 at the wall, and under both impact conditions the flux off the wall has the
/// momentum r int w f dw, where f(w) is the flux of impacts with the speed w. The impact condition
/// `delta` replaces the flux f(w) of impacts with the speed w by f + (1-r) d(w f)/dw; integration
/// by parts gives the same momentum r int w f dw. Only the balance of power, whose energy is
/// quadratic in v, distinguishes the impact condition `map` from `delta`.

/// The two sides of a balance equation, which are equal for the exact stationary density.
struct BalanceEquation {
  double left;
  double right;
  double scale;  ///< magnitude by which the residual is divided

  double left_minus_right_side() const { return left - right; }
  double relative_balance_residual() const { return left_minus_right_side() / scale; }
};

/// Returns the momentum per unit time from a wall of constant restitution coefficient r to the
/// mass, (1+r) int v^2 p(a,v) dv over the velocities v into the wall; 0 without a wall.
/// @param squared_speed_integral int v^2 p(a,v) dv over the velocities v into the wall
double impact_momentum_rate(const std::optional<Wall>& wall, double squared_speed_integral);

/// Means of a density, and the momentum from the right wall, that enter the virial balance.
struct VirialBalanceTerms {
  double mean_displacement;
  double mean_square_velocity;
  /// Mean virial E[y g(y)] of the restoring force g, or E[y (f + g)] if a formula states the total
  /// force f + g.
  double mean_virial;
  double right_impact_momentum = 0;  ///< momentum per unit time from the right wall
  double mean_y_cubed_velocity = 0;  ///< E[y v^3]; used where c_vv is not 0
};

/// Returns the two sides of the virial balance, and E[v^2] as the scale of the residual:
///
///     E[v^2] = E[y g(y)] + c_vv E[y v^3] - lambda E[Y] E[y] + b int (1 + r_b) u^2 p(b,u) du.
BalanceEquation virial_balance(const Problem& problem, const VirialBalanceTerms& terms);

/// Means of a density, and the momentum from the walls, that enter the momentum balance.
struct MomentumBalanceTerms {
  /// Mean restoring force E[g(y)], or the mean E[f + g] of the total force if a formula states f +
  /// g.
  double mean_force;
  /// Momentum per unit time from the left wall and from the right wall to the mass
  /// (impact_momentum_rate()).
  double left_impact_momentum = 0, right_impact_momentum = 0;
  double mean_cubed_velocity = 0;  ///< E[v^3]; used where c_vv is not 0
  /// Momentum per unit time from the contact force on the mass at rest and from rebounds after
  /// impulses towards the wall. At the left wall, with the probability P0 of rest in contact, the
  /// contact momentum rate is g(0) P0 + (1 + r) lambda P0 E[Y^-].
  double contact_momentum_rate = 0;
  /// Mean E[|g(y)|] of the absolute restoring force, the scale of the momentum balance for motion
  /// far from a wall, where the mean force and the momentum from the wall are nearly 0.
  double mean_absolute_force = 0;
};

/// Returns the two sides of the momentum balance, and the scale of the residual:
///
///     E[g(y)] + c_vv E[v^3] = lambda E[Y] + int (1 + r) u^2 p(0,-u) du
///                             - int (1 + r_b) u^2 p(b,u) du + contact_momentum_rate.
///
/// The scale of the momentum balance is the largest of three terms: the contribution of the spring,
/// the contribution of the walls, and E[|g(y)|]. In a symmetric potential well without a wall both
/// sides of the momentum balance are 0. For a symmetric potential well with unknown
/// mean_absolute_force, use left_minus_right_side() instead of relative_balance_residual().
BalanceEquation momentum_balance(const Problem& problem, const MomentumBalanceTerms& terms);

}  // namespace fpkcheck::problem
