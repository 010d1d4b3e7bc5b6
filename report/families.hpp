#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::report {

/// The solutions of one family, in their own order.
struct Family {
  std::string name;
  std::vector<const transform::Solution*> solutions;
};

/// All families, in the order of their first members.
std::vector<Family> families(const std::vector<const transform::Solution*>& solutions);
std::vector<Family> families(std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::report
