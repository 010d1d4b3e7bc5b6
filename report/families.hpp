#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of one family of methods, in the order of the input.
struct Family {
  std::string name;
  std::vector<const transform::Solution*> solutions;
};

/// The solutions grouped by family. The families have the order of their first members in the
/// input.
std::vector<Family> families(const std::vector<const transform::Solution*>& solutions);
std::vector<Family> families(std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::report
