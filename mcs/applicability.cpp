#include "mcs/applicability.hpp"

#include <cmath>

#include "mcs/motion/oscillator.hpp"
#include "problem/motion_scales.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::mcs {

namespace {

// Returns whether the bounces on a wall never end, because the restitution coefficient r(u) tends
// to 1 as the impact speed u tends to 0.
bool has_endless_bounces(const problem::Problem& problem) {
  const SimulatedOscillator oscillator = make_oscillator(problem, problem::motion_scales(problem));
  const auto is_endless = [](const SimulatedWall& wall) {
    return wall.formula != nullptr && wall.contact_force > 0 &&
           std::isinf(total_bounce_time(wall, wall.rest_speed));
  };
  return is_endless(oscillator.left) || is_endless(oscillator.right);
}

}  // namespace

std::string unsupported_reason(const problem::Problem& problem, const SimulationOptions& options) {
  // For a Duffing oscillator at a wall, simulate_stationary_density() itself reports an inelastic
  // collapse as a failed solution.
  if (is_duffing_at_wall(problem)) return "";
  if (problem.noise_factor) {
    if (problem.impulses.is_acting() && options.equation == DensityEquation::white) {
      return "noise.factor excludes white noise in place of the impulses; use kf";
    }
    if (problem.noise_factor->depends_on_v() && problem.noise_factor->has_jumps()) {
      return "noise.factor depends on v and has jumps (sign); smooth them: tanh(v/eps)";
    }
  }
  if (problem.impulse_factor && options.equation == DensityEquation::white) {
    return "mcs does not support white noise in place of impulses with impulse.factor; use kf, or fd";
  }
  const bool has_noise = problem.noise.is_acting() || options.equation == DensityEquation::white;
  if (!problem.system.has_constant_restitution() && !has_noise && has_endless_bounces(problem)) {
    return "the mass bounces on the wall without end, since the restitution coefficient tends to 1 "
           "with the impact speed; choose r(0) < 1";
  }
  if (problem.system.has_force_jumps_in_v() && !has_noise) {
    return "the mass can stick where the force jumps in v (sign); smooth it: tanh(v/eps)";
  }
  if (options.tails) {
    std::string why = unsupported_splitting_reason(problem, options);
    if (!why.empty()) return why;
  }
  return problem::inelastic_collapse_reason(problem, options.equation);
}

std::string unsupported_functional_reason(const problem::Problem& problem,
                                          const SimulationOptions& options) {
  const std::string reason = unsupported_reason(problem, options);
  const bool has_factor = problem.time.has_rate_factor() || problem.time.has_intensity_factor();
  if (reason.empty() && has_factor && problem.impulses.is_acting() &&
      options.equation == DensityEquation::white) {
    return "mcs does not support white noise in place of impulses with time.rate or time.intensity; "
           "use kf, or fd";
  }
  return reason.empty() ? problem::inelastic_collapse_reason(problem, options.equation) : reason;
}

std::string unsupported_splitting_reason(const problem::Problem& problem,
                                         const SimulationOptions& options) {
  // For a Duffing oscillator at a wall the damping is positive, and evenly spaced impulses replace
  // white noise, so that the energy rises at impulses only.
  if (is_duffing_at_wall(problem)) return "";
  if (!problem.system.has_polynomial_force()) {
    return "tail splitting needs a polynomial potential, and the force is a formula";
  }
  if (problem.impulse_factor) {
    return "tail splitting needs impulses that do not depend on y, and impulse.factor multiplies them";
  }
  const auto features = problem::problem_features(problem);
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
