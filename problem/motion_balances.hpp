#pragma once

#include "problem/problem.hpp"

/// The balances of virial and momentum, beside the balance of power (problem/energy_balance.hpp):
/// Dynkin's formula for f = y v and f = v under any stationary density on the half-plane,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// g the restoring force of System, with E[v] = 0 and E[y v] = 0. (These follow from f = y and
/// f = y^2/2, which neither impulse nor impact changes; likewise E[c(y) v] = E[y c(y) v] = 0 for
/// any c(y).) The balances hold in wall coordinates (problem/frame.hpp), with a left wall at 0. A
/// right wall at b, damping c_vv v^3 and atoms in contact add terms; E[g] includes the atoms.
///
/// Both f are linear in v, so that only E[Y] enters: the balances hold for `kf`, `km4`, `km4_pade`
/// and `white`, and for both impact conditions. At the wall y v = 0, and `delta`, which returns
/// f(w) + (1-r) d(w f)/dw of an outgoing flux f, returns the momentum r int w f dw as `map` does
/// (by parts). Only the balance of power, quadratic in v, distinguishes the two.
namespace fpkcheck::problem {

/// The two sides of a balance equation.
struct Balance {
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
/// relative to E[v^2].
Balance virial_balance(const Problem& problem, const VirialTerms& terms);

struct MomentumTerms {
  double mean_force;          ///< E[g(y)]
  double impact_momentum;     ///< int_{u>0} u^2 p(0,-u) du, the incoming momentum per unit time
  double right_momentum = 0;  ///< int_{u>0} u^2 p(b,u) du
  double mean_cubed_velocity = 0;  ///< E[v^3]; used where c_vv is not 0
  /// Contact force of the mass at rest and momentum of its rebounds:
  /// g(0) P0 + (1 + r) lambda P0 E[Y^-] at the left wall.
  double contact_momentum_rate = 0;
  /// E[|g(y)|], for forces of both signs: in wells far from a wall both the mean force and the
  /// momentum from the wall are nearly 0, and only this magnitude sets a scale.
  double mean_absolute_force = 0;
};

/// The momentum balance
///
///     E[g(y)] + c_vv E[v^3] = lambda E[Y] + (1 + r) int u^2 p(0,-u) du
///                             - (1 + r_b) int u^2 p(b,u) du + contact term,
///
/// relative to the larger of the spring's and the walls' contribution: a mean impulse towards the
/// wall leaves little to the spring, and one away from the wall leaves little to the wall. Without
/// a wall, in a symmetric well, both sides are 0 and the residual is meaningless: use difference().
Balance momentum_balance(const Problem& problem, const MomentumTerms& terms);

}  // namespace fpkcheck::problem
