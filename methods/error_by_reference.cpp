#include "methods/error_by_reference.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <variant>
#include <vector>

#include "compare/reference.hpp"

namespace fpkcheck::methods {

using transform::Solution;
using transform::Variable;

std::optional<double> accuracy_of(const Method& method) {
  if (method.identity.role != transform::Role::closure) return std::nullopt;
  for (const auto& [name, value] : method.options) {
    if (name != "accuracy") continue;
    if (const auto* number = std::get_if<double>(&value)) return *number;
  }
  return std::nullopt;
}

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// L1 distances of a solution's marginals from those of the reference. A marginal that one of the
// two lacks has no value.
struct Distance {
  std::optional<double> y, ydot;

  explicit operator bool() const { return y || ydot; }
};

void state_distance(const Solution& reference, const Distance& distance, Solution& solution) {
  const auto with_its_own = [&](const std::optional<double>& l1, Variable variable) {
    return l1 ? *l1 + compare::error_estimate(reference, variable) : kUnknown;
  };
  transform::ErrorEstimate error{.y_l1 = with_its_own(distance.y, Variable::y),
                                 .ydot_l1 = with_its_own(distance.ydot, Variable::ydot)};
  for (const auto& [name, symbol, moment, size] : transform::kMoments) {
    error.moments.*moment = std::abs(solution.moments.*moment - reference.moments.*moment);
    if (reference.error) error.moments.*moment += reference.error->moments.*moment;
  }
  solution.error = error;
}

}  // namespace

void complete_errors(const std::vector<Method>& methods, const compare::ComparisonAxes& axes,
                     const ProblemResiduals& residuals, std::vector<Solution>& solutions,
                     const compare::Comparison* known) {
  const Solution* const reference = compare::reference(solutions);
  std::optional<compare::Comparison> own;
  const auto distance = [&](const Solution& solution) -> Distance {
    if (reference == nullptr) return {};
    if (known == nullptr) known = &own.emplace(compare::compare_solutions(axes, solutions));
    const auto l1 = [&](Variable variable) {
      return compare::l1_between(known->pairs, solution.id(), reference->id(), variable);
    };
    return {l1(Variable::y), l1(Variable::ydot)};
  };
  for (std::size_t m = 0; m < solutions.size(); ++m) {
    Solution& solution = solutions[m];
    const auto accuracy = solution.error ? std::nullopt : accuracy_of(methods[m]);
    if (accuracy && solution.density) {
      if (const Distance found = distance(solution); found.y && found.ydot) {
        if (solution.status == transform::Status::inaccurate) {  // only since it had no estimate
          solution.status = transform::Status::ok;
          solution.reason.clear();
        }
        state_distance(*reference, found, solution);
        transform::require_accuracy(
            *accuracy,
            fmt::format(
                "the closure meets its equations, but its L1 distance from {} is {:.2g} in p(y) "
                "and {:.2g} in p(y')",
                reference->id(), *found.y, *found.ydot),
            solution);
      } else if (solution.is_ok()) {
        state_measured_error(residuals, *accuracy, solution);
      }
    } else if (solution.is_ok() && &solution != reference &&
               !transform::has_error_estimate(solution)) {
      if (const Distance found = distance(solution)) {
        state_distance(*reference, found, solution);
      } else if (methods[m].identity.role == transform::Role::closure) {
        state_measured_error(residuals, HUGE_VAL, solution);
      }
    }
    transform::require_error_estimate(solution);
  }
}

}  // namespace fpkcheck::methods
