#include "report/page/first_shown.hpp"

#include "compare/reference.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {

std::set<std::string> first_shown(const results::Case& one) {
  std::set<std::string> ids, families;
  for (const auto& rank : compare::closures_by_distance(one.solutions, one.pairs)) {
    const auto& closure = *rank.solution;
    if (families.insert(closure.identity.family).second) ids.insert(closure.id());
  }
  for (const auto* solution : references(one)) ids.insert(solution->id());
  for (const auto& solution : one.solutions) {
    if (transform::is_guest(solution.identity)) ids.insert(solution.id());
  }
  if (ids.size() < 2) {
    for (const auto& solution : one.solutions) ids.insert(solution.id());
  }
  return ids;
}

}  // namespace fpkcheck::report
