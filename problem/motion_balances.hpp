#pragma once

#include "problem/problem.hpp"

/// The balances of virial and momentum, beside that of power (problem/energy_balance.hpp): what
/// Dynkin's formula says of f = y v and f = v under any stationary density on the half-plane,
///
///     E[v f_y - (c v + g(y)) f_v] + lambda E[f(y, v + Y) - f(y, v)]
///         + int_{u>0} u p(0,-u) [f(0, +) - f(0, -u)] du = 0,
///
/// g the restoring force of System, with E[v] = 0 and E[y v] = 0 (f = y and f = y^2/2, which
/// neither impulse nor impact changes). Both f are linear in v, so that E[Y] alone enters: they
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
  double mean_displacement;     ///< E[y]
  double mean_square_velocity;  ///< E[v^2]
  double mean_virial;           ///< E[y g(y)]
};

/// E[v^2] = E[y g(y)] - lambda E[Y] E[y], relative to E[v^2].
Balance virial_balance(const Problem& problem, const VirialTerms& terms);

struct MomentumTerms {
  double mean_force;       ///< E[g(y)]
  double impact_momentum;  ///< int_{u>0} u^2 p(0,-u) du: what reaches the wall per unit time
};

/// E[g(y)] = lambda E[Y] + (1 + r) int u^2 p(0,-u) du, relative to the larger of what the spring
/// takes and the wall gives: a mean towards the wall leaves little to the spring, one away from it
/// little to the wall.
Balance momentum_balance(const Problem& problem, const MomentumTerms& terms);

}  // namespace fpkcheck::problem
