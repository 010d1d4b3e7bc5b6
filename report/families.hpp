#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of one family, in the order of the input.
struct Family {
  std::string name;
  std::vector<const transform::Solution*> solutions;
};

/// The solutions grouped by family, ordered by the first members.
std::vector<Family> families(const std::vector<const transform::Solution*>& solutions);
std::vector<Family> families(std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::report
