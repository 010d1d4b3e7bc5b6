#include "workflows/sweep/execution/solve_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include "base/files/file_transaction.hpp"
#include "base/input_error.hpp"
#include "base/process/stop_request.hpp"
#include "base/process/stopwatch.hpp"
#include "compare/comparison.hpp"
#include "compare/solution_assessment.hpp"
#include "fd_fpk/functionals/sensitivities.hpp"
#include "methods/residual_error_estimator.hpp"
#include "methods/run_cases.hpp"
#include "problem/parameter_derivative.hpp"
#include "results/marginals_csv.hpp"
#include "results/run.hpp"

namespace fpkcheck::sweep {
namespace {

using transform::Solution;
using transform::StateVariable;
using transform::Status;

Solution failed_solution(const methods::Method& method, const std::string& reason) {
  Solution solution{.identity = method.identity, .options = method.options};
  solution.status = Status::failed;
  solution.reason = reason;
  return solution;
}

Solution solution_or_failure(const methods::Method& method, const problem::Problem& problem,
                             const methods::SolverInputContext& context) {
  try {
    if (method.check) method.check(problem);
    return methods::solve_with_method(method, problem, context);
  } catch (const InputError& error) {
    return failed_solution(method, error.what());
  }
}

std::optional<MarginalL1Values> finite_error_estimate(const Solution& solution) {
  if (!solution.has_density()) return std::nullopt;
  const MarginalL1Values error{compare::l1_error_estimate(solution, StateVariable::y),
                               compare::l1_error_estimate(solution, StateVariable::ydot)};
  if (!std::isfinite(error.y) || !std::isfinite(error.ydot)) return std::nullopt;
  return error;
}

std::vector<ErrorBudgetContribution> error_budget_contributions(
    const Solution& solution, const std::vector<compare::ErrorBudgetRow>& budget) {
  std::vector<ErrorBudgetContribution> shares;
  for (const auto& closure : compare::group_budget_by_closure(budget, {&solution, 1})) {
    if (closure.solution != solution.id() || closure.y == nullptr || closure.ydot == nullptr) {
      continue;
    }
    for (const auto& part : closure.y->parts) {
      const auto* same = closure.ydot->find_budget_part(part.error_budget_part_name());
      if (same != nullptr) shares.push_back({part.error_budget_part_name(), {part.l1, same->l1}});
    }
  }
  return shares;
}

// Returns the derivatives of the second moments with respect to the varied keys with numbers as
// values, by finite volumes on coarse grids. The result is empty for other methods, without a
// density, and if the sensitivities do not have the status `ok`.
std::vector<MomentSlopes> moment_slopes(const SweepPlan& plan, const methods::Method& method,
                                        const problem::Problem& problem, const Solution& solution) {
  // On cells twice as wide as the automatic cells the derivatives with respect to the restitution
  // coefficient in case 1 have relative errors of about 3e-4.
  constexpr double kRefinement = 0.5, kAccuracy = 0.5, kStep = 1e-4;
  if (!plan.slopes || method.identity.method != "fd" || !solution.has_density()) return {};
  auto options = fd_fpk::solver_option_descriptions().read(method.options, "options");
  options.refinement *= kRefinement;
  options.accuracy = kAccuracy;
  std::vector<problem::ParameterDifferenceQuotient> parameters;
  for (const SweepAxis& axis : plan.axes) {
    try {
      parameters.push_back(problem::parameter_difference_quotient(problem, axis.key, kStep));
    } catch (const InputError&) {  // a word, the position of a wall, or an absent key
    }
  }
  if (parameters.empty()) return {};
  const auto found = fd_fpk::solve_sensitivities(problem, options, parameters, {}, {});
  if (found.status != Status::ok) return {};
  const auto derivatives_of = [&](const char* moment) {
    return std::ranges::find(found.expectations, moment,
                             &transform::ExpectationDerivatives::expectation);
  };
  const auto y2 = derivatives_of("E[y^2]"), v2 = derivatives_of("E[y'^2]");
  std::vector<MomentSlopes> slopes;
  for (std::size_t k = 0; k < parameters.size(); ++k) {
    slopes.push_back({.key = found.parameters[k],
                      .y2 = y2->derivatives[k],
                      .v2 = v2->derivatives[k],
                      .y2_error = y2->errors[k],
                      .v2_error = v2->errors[k]});
  }
  return slopes;
}

SweepMethodResult make_method_result(const Solution& solution) {
  SweepMethodResult result{.status = solution.status,
                           .reason = solution.reason,
                           .seconds = solution.seconds,
                           .error = finite_error_estimate(solution)};
  if (solution.has_density()) result.moments = solution.moments;
  return result;
}

std::optional<MarginalL1Values> l1_distance(const compare::SolutionComparison& comparison,
                                            const Solution& solution, const Solution& reference) {
  const auto l1 = [&](StateVariable variable) {
    return compare::l1_distance_between(comparison.pairs, solution.id(), reference.id(), variable);
  };
  const auto y = l1(StateVariable::y), ydot = l1(StateVariable::ydot);
  if (!y || !ydot) return std::nullopt;
  return MarginalL1Values{*y, *ydot};
}

SolvedSweepPoint solve_and_compare_methods(const SweepPlan& plan, std::size_t point) {
  SolvedSweepPoint solved_point{{.point = point}, {}};
  SweepPointResult& result = solved_point.result;
  std::optional<problem::Problem> problem;
  try {
    problem = plan.problem_at_sweep_point(point);
  } catch (const InputError& error) {
    for (const auto& method : plan.methods) {
      result.methods.push_back(make_method_result(failed_solution(method, error.what())));
    }
    return solved_point;
  }
  const auto axes = compare::comparison_bins(*problem);
  const methods::ResidualErrorEstimator residuals(*problem);
  const bool by_reference = plan.closure_errors == ClosureErrorSource::reference ||
                            !residuals.unsupported_reason().empty();
  std::vector<Solution> solutions;
  for (const auto& method : plan.methods) {
    solutions.push_back(
        solution_or_failure(method, *problem, {axes, {}, &residuals, !by_reference}));
  }

  const Solution* reference =
      transform::find_solution(solutions, compare::assess_solutions(solutions).reference);
  compare::SolutionComparison comparison;
  if (reference != nullptr || plan.marginals) {
    comparison = compare::compare_solutions(axes, solutions);
  }
  if (plan.marginals) {
    for (auto& found : comparison.marginals) {
      solved_point.curves.push_back(results::make_density_curve(std::move(found)));
    }
  }
  if (reference != nullptr) result.reference = reference->id();
  methods::complete_error_estimates(plan.methods, axes, residuals, solutions,
                                    reference != nullptr || plan.marginals ? &comparison : nullptr);
  for (std::size_t m = 0; m < solutions.size(); ++m) {
    const Solution& solution = solutions[m];
    const auto l1 =
        reference == nullptr ? std::nullopt : l1_distance(comparison, solution, *reference);
    result.methods.push_back(make_method_result(solution));
    result.methods.back().l1 = l1;
    result.methods.back().slopes = moment_slopes(plan, plan.methods[m], *problem, solution);
    if (reference != nullptr)
      result.methods.back().budget = error_budget_contributions(solution, comparison.budget);
  }
  return solved_point;
}

}  // namespace

SolvedSweepPoint solve_sweep_point(const SweepPlan& plan, std::size_t point) {
  const base::Stopwatch stopwatch;
  SolvedSweepPoint solved_point = solve_and_compare_methods(plan, point);
  solved_point.result.seconds = stopwatch.seconds();
  return solved_point;
}

void write_marginals(const SweepPlan& plan, const std::filesystem::path& directory,
                     const SolvedSweepPoint& solved) {
  if (solved.curves.empty()) return;
  const base::ProcessExitBlocker in_hand;
  std::filesystem::create_directories(directory / "marginals");
  const std::vector<results::CaseResult> cases{
      {.problem = plan.problem_at_sweep_point(solved.result.point), .curves = solved.curves}};
  std::ostringstream text;
  results::write_marginals_csv(text, cases);
  base::write_file_atomically(
      directory / "marginals" / fmt::format("{:06}.csv", solved.result.point), text.str());
}

}  // namespace fpkcheck::sweep
