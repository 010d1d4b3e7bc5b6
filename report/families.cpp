#include "report/families.hpp"

#include <algorithm>

namespace fpkcheck::report {

using transform::Solution;

std::vector<Family> families(const std::vector<const Solution*>& solutions) {
  std::vector<Family> all;
  for (const Solution* solution : solutions) {
    const std::string& name = solution->identity.family;
    auto found = std::ranges::find(all, name, &Family::name);
    if (found == all.end()) found = all.insert(found, {name, {}});
    found->solutions.push_back(solution);
  }
  return all;
}

std::vector<Family> families(std::span<const Solution> solutions) {
  std::vector<const Solution*> all;
  for (const auto& solution : solutions) all.push_back(&solution);
  return families(all);
}

}  // namespace fpkcheck::report
