#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include "made_up_sweep.hpp"
#include "workflows/sweep/execution/solve_time_forecast.hpp"
#include "workflows/sweep/report/sweep_tables.hpp"

namespace fpkcheck::sweep {
namespace {

// Seconds that are a power of the rate, with another factor for another law.
double seconds_at(const SweepPlan& plan, std::size_t point) {
  const double rate = std::get<double>(plan.points[point][0]);
  const bool laplace = plan.points[point][1] == base::Value(std::string("laplace"));
  return 0.3 * std::pow(rate, 1.5) * (laplace ? 2 : 1);
}

TEST(SolveTimeModel, FindsPowersAndWords) {
  const SweepPlan plan = tests::plan_of({parse_sweep_axis("impulse.rate", "log:0.1:10:21", "x"),
                                         parse_sweep_axis("impulse.law", "gaussian,laplace", "x")});
  std::vector<std::size_t> all(plan.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<SolveTimeModel::Measurement> measured;
  for (const auto point : evenly_spread_sample(all, 24))
    measured.push_back({point, seconds_at(plan, point)});
  const SolveTimeModel model(plan, measured);
  double sum = 0, expected = 0;
  for (const auto point : all) {
    EXPECT_NEAR(std::log(model.expected_seconds(point) / seconds_at(plan, point)), 0, 0.1) << point;
    sum += seconds_at(plan, point);
    expected += model.expected_seconds(point);
  }
  EXPECT_NEAR(expected / sum, 1, 0.03);
}

TEST(SolveTimeModel, WithoutMeasurementsAllTimesAreEqual) {
  const SweepPlan plan = tests::small_plan();
  EXPECT_EQ(SolveTimeModel(plan, {}).all_expected_seconds(), std::vector<double>(6, 1.0));
}

TEST(SolveTimeModel, MeasuredPointsKeepTheirTimes) {
  const SweepPlan plan = tests::small_plan();
  const std::vector<SolveTimeModel::Measurement> measured{{3, 7.0}, {0, 1.0}};
  EXPECT_EQ(SolveTimeModel(plan, measured).expected_seconds(3), 7);
}

TEST(Spread, GivesEachPointOnceFromAllRegions) {
  std::vector<std::size_t> all(1000);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const auto chosen = evenly_spread_sample(all, 20);
  ASSERT_EQ(chosen.size(), 20);
  std::set<std::size_t> tenths;
  for (const auto point : chosen) tenths.insert(point / 100);
  EXPECT_EQ(tenths.size(), 10);
  EXPECT_EQ(std::set<std::size_t>(chosen.begin(), chosen.end()).size(), 20);
  EXPECT_EQ(evenly_spread_sample({5, 7}, 20).size(), 2);
  EXPECT_TRUE(evenly_spread_sample({}, 20).empty());
}

TEST(Makespan, IsThatOfTheDispatch) {
  const std::vector<double> seconds{1, 1, 1, 1, 4};
  EXPECT_EQ(parallel_wall_clock_time(seconds, 1, SweepPointDispatchRule::shards), 8);
  EXPECT_EQ(parallel_wall_clock_time(seconds, 2, SweepPointDispatchRule::longest_first), 4);
  EXPECT_EQ(parallel_wall_clock_time(seconds, 2, SweepPointDispatchRule::in_order), 6);
  EXPECT_EQ(parallel_wall_clock_time(seconds, 2, SweepPointDispatchRule::shards),
            6);  // 1 + 1 + 4 and 1 + 1
  EXPECT_EQ(parallel_wall_clock_time(seconds, 100, SweepPointDispatchRule::in_order), 4);
}

TEST(SolveTimeForecast, PredictsAPlanFromASample) {
  const SweepPlan plan =
      tests::quick_plan({parse_sweep_axis("system.restitution", "0.9:1:40", "x")});
  const auto found = forecast_solve_times(plan, {}, 1);
  EXPECT_EQ(found.sample.size(), 24);
  EXPECT_EQ(found.seconds.size(), 40);
  EXPECT_GT(found.megabytes, 1);
  const std::string text = solve_time_forecast_text(plan, found, 2, {8}, {100, false});
  EXPECT_NE(text.find("40 points, 1 method:"), std::string::npos);
  EXPECT_NE(text.find("predicted from 24 points"), std::string::npos) << text;
  EXPECT_NE(text.find("    8 "), std::string::npos) << text;
}

// With all points solved before, nothing is predicted.
TEST(SolveTimeForecast, OfASolvedPlanIsMeasured) {
  const SweepPlan plan = tests::small_plan();
  const auto found = forecast_solve_times(plan, tests::results_of(plan).points, 1);
  EXPECT_EQ(found.uncertainty, 0);
  EXPECT_NEAR(parallel_wall_clock_time(found.seconds, 1, SweepPointDispatchRule::shards),
              6 * 2 + 2 * 15, 1e-9);
  EXPECT_NE(solve_time_forecast_text(plan, found, 1, {}, {100, false}).find("(measured)"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::sweep
