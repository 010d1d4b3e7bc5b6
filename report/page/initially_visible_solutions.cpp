#include "report/page/initially_visible_solutions.hpp"

#include "compare/reference.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {

std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result) {
  std::set<std::string> ids, families;
  for (const auto& rank :
       compare::closures_by_reference_distance(case_result.solutions, case_result.pairs)) {
    const auto& closure = *rank.solution;
    if (families.insert(closure.identity.family).second) ids.insert(closure.id());
  }
  for (const auto* solution : references(case_result)) ids.insert(solution->id());
  for (const auto& solution : case_result.solutions) {
    if (transform::is_external(solution.identity)) ids.insert(solution.id());
  }
  if (ids.size() < 2) {
    for (const auto& solution : case_result.solutions) ids.insert(solution.id());
  }
  return ids;
}

}  // namespace fpkcheck::report
