#pragma once

#include "problem/problem.hpp"

/// Exact results for the stationary response, as references for tests of the solvers. All hold for
/// r = 1, where the impact conserves energy and (y, y') = (|z|, z' sgn z) with (z, z') of the
/// oscillator without a wall.
namespace fpkcheck::exact {

/// Density under white noise of intensity 2 D2 with mean lambda E[Y], for r = 1. On x1 > 0
///
///     p(x1, x2) ~ exp( -(c/D2) (x2^2/2 + U(x1) - lambda E[Y] x1) ),   U the potential of g,
///
/// and p is point-symmetric about the origin of the (z, z') plane.
class WhiteNoiseDensity {
 public:
  /// @throws InputError when the restitution coefficient is not 1
  explicit WhiteNoiseDensity(const problem::Problem& problem);

  /// Joint density in the (z, z') plane, integrating to 1 over the whole plane.
  double operator()(double x1, double x2) const;
  /// p(y) for y >= 0, paper (30).
  double displacement_marginal(double y) const;
  /// p(y'), paper (34): normal density with variance D2/c.
  double velocity_marginal(double v) const;

 private:
  double beta_;        // c/D2
  double mean_force_;  // lambda E[Y]
  numerics::Polynomial potential_;
  double displacement_norm_;  // integral of exp(-beta V(y)) over y > 0
};

/// E[y'^2] = lambda E[Y^2] / (2c), for r = 1, any impulse law and any restoring force.
/// @throws InputError when the restitution coefficient is not 1
double mean_square_velocity(const problem::Problem& problem);

/// Cumulants of (z, z') for the linear oscillator (mu = 0) with r = 1 and a symmetric impulse law,
/// or of (y, y') without a wall for any law (Campbell's theorem):
///
///     kappa(z^p z'^q) = (lambda E[Y^(p+q)] + 2D [p + q = 2]) int_0^inf h(t)^p h'(t)^q dt,
///     h(t) = exp(-ct/2) sin(wt)/w,   w^2 = k - c^2/4;
///     h(t) = exp(-ct/2) sinh(wt)/w,  w^2 = c^2/4 - k;      h(t) = t exp(-ct/2)  for c^2 = 4k.
///
/// @param p,q orders, 1 <= p + q < problem::kMomentCount
/// @throws InputError for any other problem
double linear_cumulant(const problem::Problem& problem, int p, int q);

}  // namespace fpkcheck::exact
