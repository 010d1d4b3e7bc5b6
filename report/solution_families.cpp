#include "report/solution_families.hpp"

#include <algorithm>

namespace fpkcheck::report {

using transform::Solution;

std::vector<SolutionFamily> group_by_family(const std::vector<const Solution*>& solutions) {
  std::vector<SolutionFamily> all;
  for (const Solution* solution : solutions) {
    const std::string& name = solution->identity.family;
    auto found = std::ranges::find(all, name, &SolutionFamily::name);
    if (found == all.end()) found = all.insert(found, {name, {}});
    found->solutions.push_back(solution);
  }
  return all;
}

std::vector<SolutionFamily> group_by_family(std::span<const Solution> solutions) {
  std::vector<const Solution*> all;
  for (const auto& solution : solutions) all.push_back(&solution);
  return group_by_family(all);
}

}  // namespace fpkcheck::report
