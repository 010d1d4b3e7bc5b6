#include "report/references.hpp"

#include "compare/reference.hpp"

namespace fpkcheck::report {

std::vector<const transform::Solution*> references(const results::CaseResult& case_result) {
  const auto* chosen = compare::select_reference(case_result.solutions);
  if (chosen == nullptr) return {};
  std::vector<const transform::Solution*> all{chosen};
  for (const auto& solution : case_result.solutions) {
    if (&solution != chosen && compare::is_solution_of_full_problem(solution))
      all.push_back(&solution);
  }
  return all;
}

}  // namespace fpkcheck::report
