#pragma once

#include <gtest/gtest.h>

#include "mcs/solve.hpp"

namespace fpkcheck::tests {

/// Expects that a simulated and an exact value differ by at most four standard errors plus the
/// error of the reference.
inline void expect_within_four_errors(double simulated, double exact, double standard_error,
                                      const char* what, double reference_error = 0) {
  EXPECT_GT(standard_error, 0.0) << what;
  EXPECT_NEAR(simulated, exact, 4 * standard_error + reference_error)
      << what << ": " << (simulated - exact) / standard_error << " standard errors";
}

/// Simulates long enough for standard errors of at most 1e-3 in the moments.
inline mcs::SimulationResult simulate(const problem::Problem& problem, double time = 6e5,
                                      std::uint64_t seed = 20240601) {
  mcs::SimulationOptions options;
  options.time = time;
  options.seed = seed;
  return mcs::simulate_stationary_density(problem, options);
}

}  // namespace fpkcheck::tests
