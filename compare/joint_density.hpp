#pragma once

#include <string>

#include "transform/density.hpp"

namespace fpkcheck::compare {

/// The joint density of (y, y') of one solution of one case, as averages over common cells.
struct JointDensity {
  std::string case_name;
  std::string solution;  ///< id
  transform::GridDensity density;
};

}  // namespace fpkcheck::compare
