#pragma once

#include "base/options/range.hpp"

namespace fpkcheck::problem {

/// The admissible range of a coefficient of restitution.
inline base::AdmissibleRange restitution_range() {
  return {[](double r) { return r > 0 && r <= 1; }, "above 0 and at most 1"};
}

}  // namespace fpkcheck::problem
