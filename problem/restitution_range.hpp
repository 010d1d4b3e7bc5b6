#pragma once

#include "parameters/range.hpp"

namespace fpkcheck::problem {

/// What is allowed of a coefficient of restitution.
inline parameters::Range restitution_range() {
  return {[](double r) { return r > 0 && r <= 1; }, "above 0 and at most 1"};
}

}  // namespace fpkcheck::problem
