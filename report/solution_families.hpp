#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::report {

struct SolutionFamily {
  std::string name;
  std::vector<const transform::Solution*> solutions;
};

/// Groups solutions by family. The order of the families is the order of their first members in
/// `solutions`.
std::vector<SolutionFamily> group_by_family(
    const std::vector<const transform::Solution*>& solutions);
std::vector<SolutionFamily> group_by_family(std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::report
