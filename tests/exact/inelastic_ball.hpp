#pragma once

#include <vector>

namespace fpkcheck::exact {

/// The ball under gravity g and white noise 2D on an inelastic floor, without damping, y'' = -g + xi
/// and v -> -r v at y = 0, in the units g = 2D = 1. With the density q of the speeds of impact,
///
///     q(a) = int_0^inf K(a, r u) q(u) du,
///     K(a, b) = int_0^inf sqrt(3) a / (pi t^2) exp(-2 (a^2 - a b + b^2) / t + a + b - t/2)
///                         erf(sqrt(6 a b / t)) dt
///
/// the density of the speed a of return from y = 0 with the speed b (T. W. Burkhardt, S. N. Kotsev,
/// Phys. Rev. E 73, 046121 (2006), after H. P. McKean 1963). For r = 1/2 it is q = e^-u. All else
/// follows from q by the balances of y, v^n and y v.
class InelasticBall {
 public:
  /// By the trapezoidal rule in log u and log t, in which all that is integrated is smooth and falls
  /// at both ends, as u^(2 - beta) (wall_exponent.hpp) and e^-(1-r)u: to about 1e-8, in a second for
  /// r = 0.3, in more the nearer r is to where impacts accumulate.
  /// @throws InputError when impacts accumulate, or r is not below 1
  explicit InelasticBall(double restitution);

  /// E[u^n] of the speeds of impact.
  double speed_moment(int n) const;
  /// Impacts per unit time, 1 / ((1 + r) E[u]): E[v] changes by -g and by them.
  double impact_rate() const;
  /// E[y] = E[v^2].
  double mean_height() const;
  /// E[v^4].
  double fourth_velocity() const;

  /// The density K(a, b) of the return.
  static double kernel(double a, double b);

 private:
  double restitution_;
  std::vector<double> speeds_, masses_;
};

}  // namespace fpkcheck::exact
