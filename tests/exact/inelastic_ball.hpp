#pragma once

#include <vector>

namespace fpkcheck::exact {

/// Undamped ball under gravity g and white noise of intensity 2D on an inelastic floor:
/// y'' = -g + xi, and v -> -r v at y = 0, in units with g = 2D = 1. The density q of the impact
/// speeds solves
///
///     q(a) = int_0^inf K(a, r u) q(u) du,
///     K(a, b) = int_0^inf sqrt(3) a / (pi t^2) exp(-2 (a^2 - a b + b^2) / t + a + b - t/2)
///                         erf(sqrt(6 a b / t)) dt
///
/// with the density K(a, b) of the impact speed a after a start from y = 0 with the speed b
/// (T. W. Burkhardt, S. N. Kotsev, Phys. Rev. E 73, 046121 (2006), after H. P. McKean 1963). For
/// r = 1/2, q = e^-u. The moments of y and v follow from q by the balances of y, v^n and y v.
class InelasticBall {
 public:
  /// Solves the integral equation by the trapezoidal rule in log u and log t. In these variables
  /// the integrands are smooth and decay at both ends, as u^(2 - beta) (wall_exponent.hpp) and
  /// e^-(1-r)u. The error is about 1e-8. The time is a second for r = 0.3, and grows towards the
  /// restitution coefficient at which impacts accumulate.
  /// @throws InputError when impacts accumulate, or r is not below 1
  explicit InelasticBall(double restitution);

  /// Moment E[u^n] of the impact speeds.
  double speed_moment(int n) const;
  /// Impacts per unit time, 1 / ((1 + r) E[u]), from the balance of v.
  double impact_rate() const;
  /// E[y] = E[v^2].
  double mean_height() const;
  /// E[v^4].
  double fourth_velocity_moment() const;

  /// The transition density K(a, b) from the speed b after an impact to the next impact speed a.
  static double kernel(double a, double b);

 private:
  double restitution_;
  std::vector<double> speeds_, masses_;
};

}  // namespace fpkcheck::exact
