#pragma once

#include "problem/problem.hpp"

/// The balances of virial and momentum, beside that of power (problem/energy_balance.hpp): what
/// Dynkin's formula says of f = y v and f = v under any stationary density on the half-plane,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// g the restoring force of System, with E[v] = 0 and E[y v] = 0 (f = y and f = y^2/2, which
/// neither impulse nor impact changes; likewise E[c(y) v] = E[y c(y) v] = 0, whatever c(y)). They are
/// stated of problems in their frame (problem/frame.hpp), a wall on the left at 0; of a wall on the
/// right at b and of damping c_vv v^3 there are terms besides, and of atoms of rest the force at the
/// wall, E[g] being over everything. Both f are linear in v, so that E[Y] alone enters: they
/// hold for `kf`, `km4`, `km4_pade` and `white` alike. And for either impact: at the wall y v is 0,
/// and `delta`, which returns f(w) + (1-r) d(w f)/dw of an outgoing flux f, returns the momentum
/// r int w f dw just as `map` does (by parts). Only power, quadratic in v, tells the two apart.
namespace fpkcheck::problem {

/// The two sides of an identity.
struct Balance {
  double left;
  double right;
  double scale;  ///< what the residual is relative to

  double difference() const { return left - right; }
  double residual() const { return difference() / scale; }
};

struct VirialTerms {
  double mean_displacement;          ///< E[y]
  double mean_square_velocity;       ///< E[v^2]
  double mean_virial;                ///< E[y g(y)]
  double right_momentum = 0;         ///< int_{u>0} u^2 p(b,u) du
  double mean_y_cubed_velocity = 0;  ///< E[y v^3]; looked at where c_vv is not 0
};

/// E[v^2] = E[y g(y)] + c_vv E[y v^3] - lambda E[Y] E[y] + (1 + r_b) b int u^2 p(b,u) du, relative to
/// E[v^2].
Balance virial_balance(const Problem& problem, const VirialTerms& terms);

struct MomentumTerms {
  double mean_force;          ///< E[g(y)]
  double impact_momentum;     ///< int_{u>0} u^2 p(0,-u) du: what reaches the wall per unit time
  double right_momentum = 0;  ///< int_{u>0} u^2 p(b,u) du
  double mean_cubed_velocity = 0;  ///< E[v^3]; looked at where c_vv is not 0
  /// What a wall holds of the mass at rest: g(0) P0 + (1 + r) lambda P0 E[Y^-] at the one on the left.
  double held_at_rest = 0;
  /// E[|g(y)|], where the force has both signs: in wells far from a wall its mean is 0 as well as what
  /// the wall gives, and only the size of the force is a scale.
  double size_of_force = 0;
};

/// E[g(y)] + c_vv E[v^3] = lambda E[Y] + (1 + r) int u^2 p(0,-u) du - (1 + r_b) int u^2 p(b,u) du +
/// what is held at rest, relative to the larger of what the spring takes and the walls give: a mean
/// towards the wall leaves little to the spring, one away from it little to the wall. Without a
/// wall, in a symmetric well, both sides are 0 and the residual says nothing: look at difference().
Balance momentum_balance(const Problem& problem, const MomentumTerms& terms);

}  // namespace fpkcheck::problem
