#pragma once

#include <string>
#include <vector>

#include "problem/impulse_law.hpp"

namespace fpkcheck::tests {

/// Names of the laws without a table.
inline std::vector<std::string> law_names_without_table() {
  std::vector<std::string> names = problem::ImpulseLaw::law_names();
  std::erase(names, problem::TabulatedLaw::kName);
  return names;
}

/// Tables of asymmetric laws.
inline constexpr const char* kAtoms = "probability(-2:0.2,-0.5:0.3,0.1:0.1,1:0.4)";
inline constexpr const char* kDensity = "density(-1:0,-0.4:0.9,0.3:0.2,0.5:0.6,1:0.46)";

}  // namespace fpkcheck::tests
