#pragma once

#include "paper_cases.hpp"

namespace fpkcheck::tests {

inline constexpr const char* kSymmetricLaws[] = {"gaussian", "laplace", "two_point", "uniform"};

/// A linear spring and impacts without loss: what has exact solutions.
inline problem::Problem linear_problem(Parameters parameters = {}) {
  parameters.cubic = 0;
  parameters.restitution = 1;
  return make_problem(parameters);
}

}  // namespace fpkcheck::tests
