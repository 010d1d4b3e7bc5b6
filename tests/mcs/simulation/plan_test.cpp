#include "mcs/simulation/plan.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::mcs {
namespace {

TEST(Plan, ChoosesWhatIsLeftOutFromTheEquivalentLinearisation) {
  const auto problem = tests::paper_case(4);
  const auto linear = problem::equivalent_linearisation(problem);
  const Plan plan = make_plan(problem, {});
  const double time = plan.round_time() * static_cast<double>(plan.rounds) * plan.streams;
  EXPECT_NEAR(time * problem::slowest_decay(linear), 1.6e6, 4e3);
  EXPECT_NEAR(plan.burn_in * problem::slowest_decay(linear), 20, 1e-12);
  EXPECT_EQ(plan.y_bins.bins(), 140u);
  EXPECT_EQ(plan.v_bins.bins(), 140u);
  EXPECT_EQ(plan.y_bins.edges().front(), 0.0);
  EXPECT_NEAR(plan.y_bins.edges().back(), 7 * linear.displacement_deviation, 1e-12);
  EXPECT_NEAR(plan.v_bins.edges().front(), -7 * linear.velocity_deviation, 1e-12);
  EXPECT_GE(plan.threads, 1);
}

}  // namespace
}  // namespace fpkcheck::mcs
