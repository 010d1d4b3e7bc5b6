#include "methods/error_by_reference.hpp"

#include <fmt/format.h>

#include <variant>
#include <vector>

#include "compare/comparison.hpp"
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

void state_distance(const Solution& reference, const Distance& distance, double accuracy,
                    Solution& solution) {
  if (solution.status == transform::Status::inaccurate && !solution.error) {
    solution.status = transform::Status::ok;
    solution.reason.clear();
  }
  solution.error = transform::StatedError{
      .y_l1 = distance.y + compare::own_error(reference, Variable::y),
      .ydot_l1 = distance.ydot + compare::own_error(reference, Variable::ydot)};
  transform::hold_to(
      accuracy,
      fmt::format(
          "it meets its equations, but is off from {} by L1 {:.2g} in p(y) and {:.2g} in p(y')",
          reference.id(), distance.y, distance.ydot),
      solution);
}

void state_errors_by_reference(const std::vector<Method>& methods,
                               const compare::ComparisonAxes& axes,
                               const ProblemResiduals& residuals,
                               std::vector<Solution>& solutions) {
  std::vector<std::size_t> without_error;
  for (std::size_t m = 0; m < solutions.size(); ++m) {
    const Solution& solution = solutions[m];
    if (accuracy_of(methods[m]) && solution.density && !solution.error) without_error.push_back(m);
  }
  if (without_error.empty()) return;
  const Solution* reference = compare::reference(solutions);
  compare::Comparison comparison;
  if (reference != nullptr) comparison = compare::compare_solutions(axes, solutions);
  for (const std::size_t m : without_error) {
    Solution& solution = solutions[m];
    const double accuracy = *accuracy_of(methods[m]);
    const auto l1 = [&](Variable variable) -> std::optional<double> {
      if (reference == nullptr) return std::nullopt;
      return compare::l1_between(comparison.pairs, solution.id(), reference->id(), variable);
    };
    const auto y = l1(Variable::y), ydot = l1(Variable::ydot);
    if (y && ydot) {
      state_distance(*reference, {*y, *ydot}, accuracy, solution);
    } else if (solution.is_ok()) {
      state_measured_error(residuals, accuracy, solution);
    }
  }
}

}  // namespace fpkcheck::methods
