#include "methods/complete_error_estimates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "compare/assessment.hpp"

namespace fpkcheck::methods {

using transform::Solution;
using transform::Variable;

std::optional<double> required_accuracy(const Method& method) {
  if (method.identity.role != transform::SolutionRole::closure) return std::nullopt;
  for (const auto& [name, value] : method.options) {
    if (name != "accuracy") continue;
    if (const auto* number = std::get_if<double>(&value)) return *number;
  }
  return std::nullopt;
}

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// The L1 distances of the marginals of a solution from the marginals of the reference. The distance
// is empty for a variable in which the solution or the reference has no marginal.
struct Distance {
  std::optional<double> y, ydot;

  explicit operator bool() const { return y || ydot; }
};

void set_distance_estimate(const Solution& reference, const Distance& distance,
                           Solution& solution) {
  const auto with_reference_error = [&](const std::optional<double>& l1, Variable variable) {
    return l1 ? *l1 + compare::l1_error_estimate(reference, variable) : kUnknown;
  };
  transform::ErrorEstimate error{.y_l1 = with_reference_error(distance.y, Variable::y),
                                 .ydot_l1 = with_reference_error(distance.ydot, Variable::ydot)};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    error.moments.*moment = std::abs(solution.moments.*moment - reference.moments.*moment);
    if (reference.error) error.moments.*moment += reference.error->moments.*moment;
  }
  solution.error = error;
}

}  // namespace

void complete_error_estimates(const std::vector<Method>& methods,
                              const compare::ComparisonAxes& axes,
                              const ResidualErrorEstimator& estimator,
                              std::vector<Solution>& solutions,
                              const compare::Comparison* comparison) {
  const Solution* const reference =
      transform::find_solution(solutions, compare::assess_solutions(solutions).reference);
  std::optional<compare::Comparison> computed_comparison;
  const auto distance = [&](const Solution& solution) -> Distance {
    if (reference == nullptr) return {};
    if (comparison == nullptr)
      comparison = &computed_comparison.emplace(compare::compare_solutions(axes, solutions));
    const auto l1 = [&](Variable variable) {
      return compare::l1_distance_between(comparison->pairs, solution.id(), reference->id(),
                                          variable);
    };
    return {l1(Variable::y), l1(Variable::ydot)};
  };
  for (std::size_t m = 0; m < solutions.size(); ++m) {
    Solution& solution = solutions[m];
    const auto accuracy = solution.error ? std::nullopt : required_accuracy(methods[m]);
    if (accuracy && solution.density) {
      if (const Distance found = distance(solution); found.y && found.ydot) {
        if (solution.status == transform::Status::inaccurate) {  // due to the missing estimate
          solution.status = transform::Status::ok;
          solution.reason.clear();
        }
        set_distance_estimate(*reference, found, solution);
        transform::require_accuracy(
            *accuracy,
            fmt::format(
                "the closure meets its equations, but its L1 distance from {} is {:.2g} in p(y) "
                "and {:.2g} in p(y')",
                reference->id(), *found.y, *found.ydot),
            solution);
      } else if (solution.is_ok()) {
        set_residual_error_estimate(estimator, *accuracy, solution);
      }
    } else if (solution.is_ok() && &solution != reference &&
               !transform::has_error_estimate(solution)) {
      if (const Distance found = distance(solution)) {
        set_distance_estimate(*reference, found, solution);
      } else if (methods[m].identity.role == transform::SolutionRole::closure) {
        set_residual_error_estimate(estimator, HUGE_VAL, solution);
      }
    }
    transform::require_error_estimate(solution);
  }
}

}  // namespace fpkcheck::methods
