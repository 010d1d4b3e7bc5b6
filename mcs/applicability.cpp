#include "mcs/applicability.hpp"

#include "problem/features.hpp"
#include "problem/inelastic_collapse.hpp"

namespace fpkcheck::mcs {

bool has_energy_bounded_flights(const problem::Problem& problem) {
  const problem::System& system = problem.system;
  const numerics::Polynomial& g = system.restoring_force();
  const bool only_impulses = problem.impulses.is_present() && !problem.noise.is_present();
  const bool loses_energy = system.has_constant_damping() && system.damping() > 0;
  const bool has_one_wall =
      system.left_wall() && system.left_wall()->position == 0 && !system.right_wall();
  const bool is_hardening = g.degree() <= 3 && g.coefficient(0) == 0 && g.coefficient(2) == 0 &&
                            g.coefficient(1) >= 0 && g.coefficient(3) >= 0 &&
                            g.coefficient(1) + g.coefficient(3) > 0;
  return only_impulses && loses_energy && has_one_wall && is_hardening;
}

std::string unsupported_reason(const problem::Problem& problem, const Options& options) {
  if (has_energy_bounded_flights(problem)) return "";
  if (options.tails) {
    std::string why = unsupported_splitting_reason(problem, options);
    if (!why.empty()) return why;
  }
  return problem::inelastic_collapse_reason(problem, options.equation);
}

std::string unsupported_splitting_reason(const problem::Problem& problem, const Options& options) {
  const auto features = problem::features(problem);
  if (features.noise || !features.impulses || options.equation == Equation::white) {
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
