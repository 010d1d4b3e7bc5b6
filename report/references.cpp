#include "report/references.hpp"

#include "compare/reference.hpp"

namespace fpkcheck::report {

std::vector<const transform::Solution*> references(const results::Case& one) {
  const auto* chosen = compare::reference(one.solutions);
  if (chosen == nullptr) return {};
  std::vector<const transform::Solution*> all{chosen};
  for (const auto& solution : one.solutions) {
    if (&solution != chosen && compare::solves_the_problem(solution)) all.push_back(&solution);
  }
  return all;
}

}  // namespace fpkcheck::report
