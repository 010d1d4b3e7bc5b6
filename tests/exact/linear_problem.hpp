#pragma once

#include "paper_cases.hpp"

namespace fpkcheck::tests {

inline constexpr const char* kSymmetricLaws[] = {"gaussian", "laplace", "two_point", "uniform"};

/// A problem with exact solutions: linear restoring force and elastic impacts.
inline problem::Problem linear_problem(Parameters parameters = {}) {
  parameters.cubic = 0;
  parameters.restitution = 1;
  return make_problem(parameters);
}

}  // namespace fpkcheck::tests
