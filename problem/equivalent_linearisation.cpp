#include "problem/equivalent_linearisation.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <numbers>

namespace fpkcheck::problem {

EquivalentLinearisation equivalent_linearisation(const Problem& problem) {
  const System& system = problem.system;
  const double d2 = problem.impulses.intensity() / 2;
  const auto stiffness = [&](double s1) {
    return system.stiffness() + 3 * system.cubic() * s1 * s1;
  };
  const auto damping = [&](double k_eq) {
    // sigma_2 / sigma_1 = sqrt(k_eq)
    return system.damping() + (1 - system.restitution()) * 2 / std::numbers::pi * std::sqrt(k_eq);
  };
  // sigma_1^2 k_eq c_eq = D2: the left side grows from 0 without bound, so there is one root.
  const auto excess = [&](double s1) {
    const double k_eq = stiffness(s1);
    return s1 * s1 * k_eq * damping(k_eq) - d2;
  };
  double upper = 1;
  while (excess(upper) <= 0) upper *= 2;
  std::uintmax_t iterations = 200;
  const auto [low, high] = boost::math::tools::toms748_solve(
      excess, 0.0, upper, boost::math::tools::eps_tolerance<double>(52), iterations);
  const double s1 = (low + high) / 2;
  const double k_eq = stiffness(s1);
  return {damping(k_eq), k_eq, s1, s1 * std::sqrt(k_eq)};
}

}  // namespace fpkcheck::problem
