#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "exact/closed_forms.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"
#include "simulate_and_compare.hpp"

namespace fpkcheck::mcs {
namespace {

SimulationResult simulate_under_white_noise(const problem::Problem& problem, double time,
                                            std::optional<double> step = {}) {
  return simulate_stationary_density(
      problem, {.equation = DensityEquation::white, .time = time, .white_step = step});
}

TEST(WhiteNoise, WithoutLossesHasItsExactDensity) {
  for (const double mean : {0.0, 0.15}) {
    SCOPED_TRACE(mean);
    const auto problem = tests::make_problem({.cubic = 1, .restitution = 1, .mean = mean});
    const SimulationResult result = simulate_under_white_noise(problem, 2e5);
    EXPECT_EQ(result.solution.id(), "mcs-white");
    EXPECT_EQ(result.solution.identity.equation, DensityEquation::white);
    const exact::WhiteNoiseDensity exact(problem);
    double distances[2] = {0, 0};
    for (const auto& [variable, estimate] : result.solution.estimated_marginals) {
      const bool is_y = variable == transform::StateVariable::y;
      for (std::size_t b = 0; b < estimate.size(); ++b) {
        const double x = estimate.bin_centre(b);
        const double p = is_y ? exact.displacement_marginal(x) : exact.velocity_marginal(x);
        distances[is_y ? 0 : 1] += std::abs(estimate.density[b] - p) * estimate.bin_width(b);
      }
    }
    EXPECT_LT(distances[0], 1.5 * *result.solution.sampling->y);
    EXPECT_LT(distances[1], 1.5 * *result.solution.sampling->ydot);
    // The weights would hide a wrong intensity, so the test uses the excess power.
    tests::expect_within_four_errors(result.summary.excess_power, 0,
                                     result.summary.excess_power_error, "power");
    tests::expect_within_four_errors(result.solution.energy_residual, 0,
                                     result.solution.standard_errors->energy_residual,
                                     "balance of power");
  }
}

// With losses the kicks determine how near the wall the oscillator rests: an error of first order.
TEST(WhiteNoise, WithLossesHasAnErrorOfTheFirstOrderInTheStep) {
  const auto problem = tests::make_problem({.restitution = 0.5});
  double stated = 0;  // error estimate of the last simulation
  const auto v2 = [&](double step) {
    const SimulationResult result = simulate_under_white_noise(problem, 1e6, step);
    stated = result.solution.error->moments.v2;
    return MeanEstimate{result.solution.moments.v2, result.solution.standard_errors->moments.v2};
  };
  const MeanEstimate coarse = v2(0.4);
  const double stated_coarse = stated;
  const MeanEstimate middle = v2(0.2), fine = v2(0.1);
  const double first = middle.mean - coarse.mean, second = fine.mean - middle.mean;
  const double error = std::hypot(coarse.standard_error, middle.standard_error);
  EXPECT_GT(first, 3 * error);
  EXPECT_NEAR(second, first / 2, 4 * error);
  // Between the steps 0.8 and 0.4 the error decreases by more than a factor of 2.
  const double coarse_error = first + 2 * second;
  EXPECT_GT(stated_coarse, coarse_error - 4 * error);
  EXPECT_LT(stated_coarse, 3 * coarse_error + 4 * error);
}

TEST(WhiteNoise, IsRefusedWhereImpactsAccumulate) {
  const auto problem = tests::make_problem({.restitution = 0.15});
  const auto solution = simulate_under_white_noise(problem, 1e4).solution;
  EXPECT_EQ(solution.status, transform::Status::failed);
  EXPECT_EQ(solution.id(), "mcs-white");
  EXPECT_FALSE(solution.has_density());
  EXPECT_NE(solution.reason.find("inelastic collapse"), std::string::npos) << solution.reason;
  // Separate impulses cause no inelastic collapse.
  EXPECT_TRUE(simulate_stationary_density(problem, {.time = 1e4}).solution.has_density());
  EXPECT_TRUE(simulate_under_white_noise(tests::make_problem({.restitution = 0.2}), 1e4)
                  .solution.has_density());
}

}  // namespace
}  // namespace fpkcheck::mcs
