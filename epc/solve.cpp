#include "epc/solve.hpp"

#include "base/process/stopwatch.hpp"
#include "epc/contact/coordinates.hpp"
#include "epc/formulations.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::epc {
namespace {

ClosureResult solve_formulation(const problem::Problem& problem, const ClosureOptions& options) {
  switch (options.formulation) {
    case Formulation::gaussian:
      return gaussian::solve_closure(problem, options);
    case Formulation::moment:
      return moment::solve_closure(problem, options);
    case Formulation::polar:
      return contact::spring_presses_on_single_wall(problem)
                 ? contact::solve_closure(problem, options)
                 : polar::solve_closure(problem, options);
  }
  return {};
}

}  // namespace

ClosureResult solve_closure(const problem::Problem& problem, const ClosureOptions& options) {
  validate(options);
  const base::Stopwatch stopwatch;
  ClosureResult result = solve_formulation(problem, options);
  auto& [solution, summary] = result;
  summary.order = options.order;
  summary.formulation = options.formulation;
  solution.identity = solution_identity(options);
  solution.metrics = solver_metrics(summary, summary.moments);
  solution.seconds = stopwatch.seconds();
  return result;
}

namespace {

std::string wall_unsupported_reason(const problem::ProblemFeatures& features) {
  if (features.rests_in_contact) {
    return "the mass comes to rest at a wall: an exponential polynomial of y and y' has no atom; "
           "use epc-polar, fd or mcs";
  }
  if (features.collapse) {
    return "impacts accumulate under noise: a restitution coefficient is <= exp(-pi / sqrt 3); "
           "no exponential polynomial has the density at the wall";
  }
  return "";
}

// Without white noise the oscillator sticks at rest where the force jumps, and the stationary law
// has an atom or a density on a line.
std::string force_jump_reason(const problem::Problem& problem, const ClosureOptions& options) {
  const bool noise =
      problem.noise.is_acting() || closure_density_equation(options) == DensityEquation::white;
  if (noise || !problem.system.has_force_jumps()) return "";
  return "the mass sticks where the force jumps (sign): no exponential polynomial has the "
         "singular part of the law; smooth the jump: tanh(v/eps)";
}

std::string gaussian_unsupported_reason(const problem::Problem& problem,
                                        const problem::ProblemFeatures& features,
                                        const ClosureOptions& options) {
  const bool is_polynomial = problem.system.has_polynomial_force();
  if (features.two_walls || (!features.no_wall && is_polynomial && !features.constant_damping)) {
    return "the formulation gaussian supports one wall with constant damping, or no wall";
  }
  if (features.no_wall && closure_density_equation(options) == DensityEquation::kf) {
    return "the jump integral of the formulation gaussian needs a wall: use equation km4 or white";
  }
  return wall_unsupported_reason(features);
}

}  // namespace

std::string unsupported_reason(const problem::Problem& problem, const ClosureOptions& options) {
  if (options.formulation == Formulation::polar) {
    std::string why = problem::polynomial_method_unsupported_reason(problem);
    if (!why.empty()) return why;
  }
  if (problem::has_equivalent_linearisation(problem)) return "";
  if (problem.impulse_factor) {
    return "the closures do not support impulse.factor; use fd or mcs";
  }
  if (std::string why = force_jump_reason(problem, options); !why.empty()) return why;
  const problem::ProblemFeatures features = problem::problem_features(problem);
  switch (options.formulation) {
    case Formulation::gaussian:
      return gaussian_unsupported_reason(problem, features, options);
    case Formulation::moment:
      return wall_unsupported_reason(features);
    case Formulation::polar:
      if (contact::spring_presses_on_single_wall(problem)) return "";
      return features.rests_in_contact
                 ? "with an atom, the formulation polar needs one wall against which the force "
                   "presses everywhere; use fd or mcs"
                 : "the formulation polar needs one wall at the equilibrium, constant damping and "
                   "impulses alone";
  }
  return "";
}

}  // namespace fpkcheck::epc
