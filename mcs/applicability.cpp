#include "mcs/applicability.hpp"

#include "mcs/motion/oscillator.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::mcs {

std::string unsupported_reason(const problem::Problem& problem, const Options& options) {
  if (problem.noise_factor) return "the simulation does not treat noise.factor; use fd";
  if (!problem.system.has_constant_restitution()) {
    return "the simulation needs constant restitution coefficients; use fd";
  }
  // For a Duffing oscillator at a wall, solve() itself reports an inelastic collapse as a failed
  // solution.
  if (is_duffing_at_wall(problem)) return "";
  const bool has_noise = problem.noise.is_present() || options.equation == DensityEquation::white;
  if (problem.system.has_force_jumps() && !has_noise) {
    return "the mass sticks where the force jumps (sign); smooth it: tanh(v/eps)";
  }
  if (options.tails) {
    std::string why = unsupported_splitting_reason(problem, options);
    if (!why.empty()) return why;
  }
  return problem::inelastic_collapse_reason(problem, options.equation);
}

std::string unsupported_splitting_reason(const problem::Problem& problem, const Options& options) {
  // For a Duffing oscillator at a wall, c > 0 and evenly spaced impulses replace the white noise.
  if (is_duffing_at_wall(problem)) return "";
  if (!problem.system.has_polynomial_force()) {
    return "tail splitting needs a polynomial potential, and the force is a formula";
  }
  const auto features = problem::features(problem);
  if (features.noise || !features.impulses || options.equation == DensityEquation::white) {
    return "tail splitting needs an energy that rises at impulses only, and noise raises the "
           "energy at all times";
  }
  if (features.negative_damping) {
    return "tail splitting needs an energy that rises at impulses only, and this damping adds "
           "energy to the motion";
  }
  return "";
}

}  // namespace fpkcheck::mcs
