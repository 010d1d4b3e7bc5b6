#include "report/solutions_of_full_problem.hpp"

#include <fmt/format.h>

#include "compare/assessment.hpp"

namespace fpkcheck::report {

std::vector<const transform::Solution*> solutions_of_full_problem(
    const results::CaseResult& case_result) {
  const auto* chosen = case_result.reference();
  if (chosen == nullptr) return {};
  std::vector<const transform::Solution*> all{chosen};
  for (const auto& solution : case_result.solutions) {
    if (&solution != chosen && compare::is_solution_of_full_problem(solution))
      all.push_back(&solution);
  }
  return all;
}

std::string describe_reference(const results::CaseResult& case_result) {
  const auto& assessment = case_result.assessment;
  if (assessment.reference.empty())
    return "There is no reference: no solution of the full problem has status ok.";
  const std::string known =
      assessment.is_reference_selected_by_error()
          ? fmt::format(
                ", the solution with the smallest error estimate (L1 {:.1g} in p(y), {:.1g} in "
                "p(y'))",
                assessment.reference_y_l1, assessment.reference_ydot_l1)
          : std::string();
  return fmt::format("Reference: {}{}.", assessment.reference, known);
}

}  // namespace fpkcheck::report
