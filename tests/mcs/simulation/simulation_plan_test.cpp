#include "mcs/simulation/simulation_plan.hpp"

#include <gtest/gtest.h>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::mcs {
namespace {

TEST(SimulationPlan, ComputesDefaultsFromTheEquivalentLinearisation) {
  const auto problem = tests::paper_case(4);
  const auto linear = problem::equivalent_linearisation(problem);
  const SimulationPlan plan = make_simulation_plan(problem, {});
  const double time =
      plan.simulated_time_per_round() * static_cast<double>(plan.rounds) * plan.streams;
  EXPECT_NEAR(time * problem::slowest_decay_rate(linear), 1.6e6, 4e3);
  EXPECT_NEAR(plan.burn_in * problem::slowest_decay_rate(linear), 20, 1e-12);
  EXPECT_EQ(plan.y_bins.bin_count(), 140u);
  EXPECT_EQ(plan.v_bins.bin_count(), 140u);
  EXPECT_EQ(plan.y_bins.edges().front(), 0.0);
  EXPECT_NEAR(plan.y_bins.edges().back(), 7 * linear.displacement_deviation, 1e-12);
  EXPECT_NEAR(plan.v_bins.edges().front(), -7 * linear.velocity_deviation, 1e-12);
  EXPECT_GE(plan.threads, 1);
}

problem::Problem problem_without_wall(double rate, double damping = 0.2, double stiffness = 1) {
  return tests::with_impulses(
      problem::System({.damping = damping, .stiffness = stiffness, .cubic = 1}, {.none = true}),
      tests::gaussian_impulses(rate, 0.1));
}

double planned_time(const SimulationPlan& plan) {
  return plan.simulated_time_per_round() * static_cast<double>(plan.rounds) * plan.streams;
}

// With 1e4 impulses per unit time the default time suffices for the accuracy, takes at most a
// minute, and follows a sufficient burn-in. The full time of the paper's oscillator would have 3e11
// impulses.
TEST(SimulationPlan, OfFrequentImpulsesIsBoundedAndEnough) {
  for (const auto& problem : {problem_without_wall(1e4), tests::make_problem({.rate = 1e4})}) {
    const SimulationPlan plan = make_simulation_plan(problem, {});
    EXPECT_EQ(plan.short_burn_in_cause, ShortBurnInCause::none);
    EXPECT_LT((planned_time(plan) + plan.burn_in * plan.streams) * 1e4, 4e9);
    // 2.5 / sqrt(1e4 decay times) = 0.025.
    EXPECT_GT(planned_time(plan) / (plan.burn_in / 20), 1e4);
    // A lower accuracy needs less time.
    EXPECT_LE(planned_time(make_simulation_plan(problem, {.accuracy = 0.1})), planned_time(plan));
  }
  EXPECT_LT(planned_time(make_simulation_plan(problem_without_wall(1e4), {.accuracy = 0.1})),
            0.1 * planned_time(make_simulation_plan(problem_without_wall(1e4), {})));
}

TEST(SimulationPlan, StatesTheCauseOfAShortBurnIn) {
  const auto limit = [](const problem::Problem& problem) {
    return make_simulation_plan(problem, {}).short_burn_in_cause;
  };
  EXPECT_EQ(limit(problem_without_wall(1)), ShortBurnInCause::none);
  EXPECT_EQ(limit(problem_without_wall(1e7)), ShortBurnInCause::impulses);
  EXPECT_EQ(limit(tests::make_problem({.rate = 1e7})), ShortBurnInCause::impulses);
  EXPECT_EQ(limit(problem_without_wall(1, 1e-9)), ShortBurnInCause::decay);
  problem::Problem two_wells = problem_without_wall(1, 0.2, -1);
  two_wells.impulses = {};
  two_wells.noise.intensity = 0.006;
  EXPECT_EQ(limit(two_wells), ShortBurnInCause::wells);
}

}  // namespace
}  // namespace fpkcheck::mcs
