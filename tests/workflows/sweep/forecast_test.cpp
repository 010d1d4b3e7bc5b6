#include "workflows/sweep/execution/forecast.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "made_up_sweep.hpp"
#include "workflows/sweep/report/forecast_text.hpp"

namespace fpkcheck::sweep {
namespace {

TEST(Makespan, IsThatOfTheDispatch) {
  const std::vector<double> seconds{1, 1, 1, 1, 4};
  EXPECT_EQ(makespan(seconds, 1, DispatchRule::shards), 8);
  EXPECT_EQ(makespan(seconds, 2, DispatchRule::longest_first), 4);
  EXPECT_EQ(makespan(seconds, 2, DispatchRule::in_order), 6);
  EXPECT_EQ(makespan(seconds, 2, DispatchRule::shards), 6);  // 1 + 1 + 4 and 1 + 1
  EXPECT_EQ(makespan(seconds, 100, DispatchRule::in_order), 4);
}

TEST(Forecast, PredictsAPlanFromASample) {
  const Plan plan = tests::quick_plan({parse_axis("system.restitution", "0.9:1:40", "x")});
  const auto found = forecast(plan, {}, 1);
  EXPECT_EQ(found.sample.size(), 24);
  EXPECT_EQ(found.seconds.size(), 40);
  EXPECT_GT(found.megabytes, 1);
  const std::string text = forecast_text(plan, found, 2, {8}, {100, false});
  EXPECT_NE(text.find("40 points, 1 method:"), std::string::npos);
  EXPECT_NE(text.find("predicted from 24 points"), std::string::npos) << text;
  EXPECT_NE(text.find("    8 "), std::string::npos) << text;
}

// With all points solved before, nothing is predicted.
TEST(Forecast, OfASolvedPlanIsMeasured) {
  const Plan plan = tests::small_plan();
  const auto found = forecast(plan, tests::results_of(plan).points, 1);
  EXPECT_EQ(found.uncertainty, 0);
  EXPECT_NEAR(makespan(found.seconds, 1, DispatchRule::shards), 6 * 2 + 2 * 15, 1e-9);
  EXPECT_NE(forecast_text(plan, found, 1, {}, {100, false}).find("(measured)"), std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::sweep
