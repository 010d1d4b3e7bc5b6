#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"
#include "thorough.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// r from 0.3 to 1, lambda from 0.2 to 20, mu from 0 to 10, intensities from 0.1 to 1.
TEST(Robustness, RandomProblemsMeetTheLimitsOfMassEnergyAndSign) {
  std::mt19937_64 engine(2026);
  const auto uniform = [&](double from, double to) {
    return from + (to - from) * std::generate_canonical<double, 53>(engine);
  };
  for (int k = 0; k < tests::part_unless_thorough(14, 40); ++k) {
    const double restitution = uniform(0.3, 1);
    const double rate = 0.2 * std::pow(100, uniform(0, 1));
    const double cubic = uniform(0, 10);
    const double intensity = 0.1 * std::pow(10, uniform(0, 1));
    const auto p = tests::make_problem(
        {.cubic = cubic, .restitution = restitution, .rate = rate, .intensity = intensity});
    const auto solution =
        solve_stationary_density(p, {.stepper = StationarySolver::direct, .error_estimate = false})
            .solution;
    SCOPED_TRACE("problem " + std::to_string(k) + ", r = " + std::to_string(restitution) +
                 ", lambda = " + std::to_string(rate) + ", mu = " + std::to_string(cubic));
    EXPECT_EQ(solution.status, transform::Status::ok) << solution.reason;
    EXPECT_NEAR(solution.mass, 1, 1e-10);
    EXPECT_LT(std::abs(solution.energy_residual), 1e-3);
    EXPECT_GT(solution.min_density, -1e-5);
  }
}

TEST(Robustness, ABoxWithMoreCellsThanAnIntHoldsIsRefused) {
  for (const double y : {1e20, 1e300}) {
    const auto solution = solve_stationary_density(tests::paper_case(1), {.x1_max = y}).solution;
    EXPECT_EQ(solution.status, transform::Status::failed);
    EXPECT_NE(solution.reason.find("cells, more than 100000: use fewer cells"), std::string::npos)
        << solution.reason;
    EXPECT_EQ(solution.reason.find('-'), std::string::npos) << solution.reason;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
