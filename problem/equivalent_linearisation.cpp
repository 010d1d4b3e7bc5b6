#include "problem/equivalent_linearisation.hpp"

#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "numerics/roots/bracketed_root.hpp"

namespace fpkcheck::problem {

namespace {

// Returns the positive root of a continuous function that is negative at 0 and increases without
// bound.
template <class Function>
double positive_root(const Function& f) {
  double upper = 1;
  while (f(upper) <= 0) upper *= 2;
  return numerics::bracketed_root(f, 0, upper);
}

// Returns E[g'(|x|)] for x ~ N(0, s^2), with E|x|^m = s^m 2^(m/2) Gamma((m+1)/2) / sqrt(pi).
double mean_tangent_stiffness(const System& system, double s) {
  const numerics::Polynomial& slope = system.tangent_stiffness();
  double mean = 0;
  for (std::size_t m = 0; m <= slope.degree(); ++m) {
    if (slope.coefficient(m) == 0) continue;
    // The absolute moment E|u|^m of a standard normal u is (m-1)!! for even m.
    const double absolute_moment = m == 0
                                       ? 1
                                       : std::pow(2, static_cast<double>(m) / 2) *
                                             boost::math::tgamma((static_cast<double>(m) + 1) / 2) *
                                             std::numbers::inv_sqrtpi;
    mean += slope.coefficient(m) * absolute_moment * std::pow(s, m);
  }
  return mean;
}

}  // namespace

bool has_equivalent_linearisation(const Problem& problem) {
  const System& system = problem.system;
  if (!system.has_polynomial_force() || !system.has_constant_restitution() ||
      problem.impulse_factor) {
    return false;
  }
  const auto& g = system.restoring_force().coefficients();
  return system.left_wall() && system.left_wall()->position == 0 && !system.right_wall() &&
         system.has_constant_damping() && system.damping() > 0 && g[0] == 0 && g[1] >= 0 &&
         g[2] == 0 && g[3] >= 0 && g[5] == 0 && g[1] + g[3] > 0 && problem.impulses.is_acting() &&
         !problem.noise.is_acting();
}

EquivalentLinearisation equivalent_linearisation(const Problem& problem) {
  const System& system = problem.system;
  const double d2 = problem.impulses.intensity() / 2;
  const auto stiffness = [&](double s1) { return mean_tangent_stiffness(system, s1); };
  const auto damping = [&](double k_eq) {
    // The ratio sigma_2 / sigma_1 of the standard deviations is sqrt(k_eq).
    return system.damping() + (1 - system.restitution()) * 2 / std::numbers::pi * std::sqrt(k_eq);
  };
  // The equation sigma_1^2 k_eq c_eq = D2 has exactly one root, the standard deviation sigma_1 of
  // the displacement, since the left side of the equation increases from 0 without bound.
  const auto excess = [&](double s1) {
    const double k_eq = stiffness(s1);
    return s1 * s1 * k_eq * damping(k_eq) - d2;
  };
  const double s1 = positive_root(excess);
  const double k_eq = stiffness(s1);
  return {damping(k_eq), k_eq, s1, s1 * std::sqrt(k_eq)};
}

double slowest_decay_rate(const EquivalentLinearisation& linearised) {
  const double discriminant = linearised.damping * linearised.damping - 4 * linearised.stiffness;
  if (discriminant <= 0) return linearised.damping / 2;
  // The quotient form of the decay rate avoids the cancellation in c_eq - sqrt(c_eq^2 - 4 k_eq).
  return 2 * linearised.stiffness / (linearised.damping + std::sqrt(discriminant));
}

double impulses_per_decay_time(const Problem& problem) {
  return problem.impulses.arrival_rate() / slowest_decay_rate(equivalent_linearisation(problem));
}

double static_deflection(const Problem& problem) {
  const double force = problem.impulses.rate_times_moment(1);
  if (force <= 0) return 0;
  return positive_root([&](double y) { return problem.system.restoring_force()(y) - force; });
}

}  // namespace fpkcheck::problem
