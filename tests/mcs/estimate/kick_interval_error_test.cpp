#include "mcs/estimate/kick_interval_error.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "general_oscillators.hpp"
#include "mcs/solve.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using problem::Problem;

bool affects_density(const Problem& problem, const SimulationOptions& options = {}) {
  return kick_interval_affects_stationary_density(make_simulation_plan(problem, options));
}

Problem oscillator_under_noise(const problem::SystemCoefficients& coefficients,
                               double restitution) {
  return tests::in_wall_coordinates(tests::with_noise(
      problem::System(coefficients, {.left = 0.2, .left_restitution = restitution}), 0.2));
}

TEST(KickIntervalError, IsAbsentWhereKicksAndFlightsPreserveTheLaw) {
  EXPECT_FALSE(affects_density(oscillator_under_noise({.damping = 0.1, .cubic = 0.3}, 1)));
  EXPECT_FALSE(affects_density(tests::make_problem({})));  // impulses without kicks
  // Each of the following properties causes an error.
  EXPECT_TRUE(affects_density(oscillator_under_noise({.damping = 0.1, .stiffness = 1}, 0.9)));
  EXPECT_TRUE(affects_density(
      oscillator_under_noise({.damping = 0.1, .van_der_pol = 0.1, .stiffness = 1}, 1)));
  Problem with_impulses =
      tests::with_noise(problem::System({.damping = 0.1, .stiffness = 1}, {.none = true}), 0.2);
  with_impulses.impulses = tests::gaussian_impulses(1, 0.5);
  EXPECT_TRUE(affects_density(with_impulses));
  EXPECT_TRUE(affects_density(tests::make_problem({.restitution = 1}),
                              {.equation = DensityEquation::white}));
}

TEST(KickIntervalError, ComparesWithTwiceTheIntervalAndOtherRandomNumbers) {
  const Problem problem = oscillator_under_noise({.damping = 0.1, .stiffness = 1}, 0.9);
  const SimulationPlan plan = make_simulation_plan(problem, {});
  const SimulationPlan doubled = *plan_with_doubled_kick_interval(problem, plan);
  EXPECT_EQ(doubled.kicks.longest_interval, 2 * plan.kicks.longest_interval);
  EXPECT_EQ(doubled.kicks.shortest_interval, 2 * plan.kicks.shortest_interval);
  EXPECT_EQ(doubled.kicks.fraction_near_wall, 2 * plan.kicks.fraction_near_wall);
  EXPECT_NE(doubled.seed, plan.seed);
  const Problem impulses = tests::make_problem({});
  EXPECT_FALSE(plan_with_doubled_kick_interval(impulses, make_simulation_plan(impulses, {})));

  const Problem paper = tests::make_problem({});
  const SimulationOptions white{.equation = DensityEquation::white};
  const SimulationPlan even = make_simulation_plan(paper, white);
  const SimulationPlan even_doubled = *plan_with_doubled_kick_interval(paper, even);
  EXPECT_EQ(even_doubled.excitation.interval, 2 * even.excitation.interval);
  EXPECT_EQ(even_doubled.excitation.arrivals, ImpulseProcess::Arrivals::even);
}

TEST(KickIntervalError, ExtrapolatesADifferenceThatTheSimulationsResolve) {
  EXPECT_DOUBLE_EQ(kick_interval_error(-0.3, 0.1, 1), 0.3);
  EXPECT_DOUBLE_EQ(kick_interval_error(0.3, 0.1, 2), 0.1);
  EXPECT_DOUBLE_EQ(kick_interval_error(0.05, 0.1, 1), 0.1);
  EXPECT_DOUBLE_EQ(kick_interval_l1_error(0.5, 0.3, 0.4, 1), 0.4);
  EXPECT_DOUBLE_EQ(kick_interval_l1_error(0.5, 0.3, 0.4, 2), 0.4 / 3);
  EXPECT_DOUBLE_EQ(kick_interval_l1_error(0.35, 0.3, 0.4, 1), 0.15);
}

TEST(KickIntervalError, IsPartOfTheErrorThatTheAccuracyLimits) {
  const Problem problem = tests::make_problem({.restitution = 0.5});
  const auto solution_with_step = [&](double step) {
    return simulate_stationary_density(
               problem, {.equation = DensityEquation::white, .time = 3e5, .white_step = step})
        .solution;
  };
  const transform::Solution coarse = solution_with_step(0.4), fine = solution_with_step(0.1);
  EXPECT_LT(*coarse.sampling->ydot_99, 0.02);
  EXPECT_EQ(coarse.status, transform::Status::inaccurate);
  EXPECT_NE(coarse.reason.find("--white-step"), std::string::npos) << coarse.reason;
  EXPECT_TRUE(fine.has_status_ok()) << fine.reason;
  EXPECT_LT(fine.error->ydot_l1, coarse.error->ydot_l1 / 2);
}

// The simulation asks once between two rounds, and then before each round of the second simulation.
TEST(KickIntervalError, IsAbsentAfterAnInterruptionOfTheSecondSimulation) {
  const Problem problem = tests::make_problem({.restitution = 0.5});
  SimulationOptions options{.equation = DensityEquation::white, .time = 1e4, .accuracy = 1};
  const SimulationResult complete = simulate_stationary_density(problem, options);
  ASSERT_TRUE(complete.solution.error);
  std::uint64_t questions = 0;
  options.stop = [&] { return ++questions > complete.summary.rounds; };
  const SimulationResult interrupted = simulate_stationary_density(problem, options);
  EXPECT_EQ(interrupted.summary.rounds, complete.summary.rounds);
  EXPECT_TRUE(interrupted.summary.interrupted);
  EXPECT_EQ(interrupted.solution.status, transform::Status::not_converged);
  EXPECT_FALSE(interrupted.solution.error);
}

}  // namespace
}  // namespace fpkcheck::mcs
