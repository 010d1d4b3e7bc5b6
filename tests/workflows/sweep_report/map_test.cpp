#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "made_up_sweep.hpp"
#include "shown_figure.hpp"
#include "workflows/sweep/report/figure/figures.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::points_of;
using tests::series_of;
using transform::Status;

report::Figure map_of(const SweepResults& results) {
  return distance_map_figure(SweepResultsView(results));
}

SweepResults two_keys() {
  return tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates});
}

TEST(Map, HasAPanelForEachMethodButTheReference) {
  const auto figure = map_of(two_keys());
  std::vector<std::string> titles;
  for (const auto& panel : figure.panels) titles.push_back(panel.title);
  EXPECT_EQ(titles, (std::vector<std::string>{"epc-gaussian-n4", "epc-moment-n4", "fd-white"}));
  const auto& map = *figure.panels[1].map;
  EXPECT_EQ(map.columns, 5u);
  EXPECT_EQ(map.values.size(), 15u);
  EXPECT_EQ(map.values[0], 0.2);  // the larger distance, for the first values of the keys
  EXPECT_TRUE(map.colour_axis.is_logarithmic);
}

TEST(Map, HasContoursWhereDistancesCrossOneAndFivePerCent) {
  const auto figure = map_of(two_keys());
  for (const char* level : {"1 %", "5 %"}) {
    EXPECT_GE(series_of(figure.panels[1], level).points.size(), 3u) << level;
    // The constant 0.03 is on one side of each level.
    EXPECT_TRUE(series_of(figure.panels[2], level).points.empty()) << level;
  }
}

TEST(Map, InterpolatesContoursBetweenTheCentresOfCells) {
  auto results = tests::made_up_sweep({{"system.restitution", "0.6:1:2"}, tests::kThreeRates});
  for (auto& point : results.points) {
    const bool is_left = results.plan.points[point.point][0] == base::Value(0.6);
    const double l1 = is_left ? 1e-3 : 1e-1;
    point.methods[tests::made_up_moment].l1 = MarginalL1Values{l1, l1};
  }
  // The logarithm of 0.01 is halfway between the columns.
  EXPECT_EQ(points_of(map_of(results).panels[1], "1 %"),
            "0.5 0, 0.5 1, 0.5 nan, 0.5 1, 0.5 2, 0.5 nan");
}

TEST(Map, MarksEachStatusByADistinctShape) {
  auto results = two_keys();
  std::size_t point = 0;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    results.points[point++].methods[tests::made_up_moment].status = status;
  }
  const auto figure = map_of(results);
  std::set<std::string> symbols;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    if (status == Status::ok) continue;
    const auto& marks = series_of(figure.panels[1], std::string(name));
    EXPECT_EQ(marks.points.size(), 1u) << name;
    EXPECT_TRUE(symbols.insert(marks.symbol).second) << name;
  }
  EXPECT_TRUE(symbols.insert(series_of(figure.panels[1], "the reference").symbol).second);
}

TEST(Map, OutlinesCellsThatAreNotOk) {
  const auto figure = map_of(two_keys());
  // For gaussian the cell (0, 1) alone is ok; it has three borders within the map.
  EXPECT_EQ(points_of(figure.panels[0], "outline: not ok"),
            "-0.5 0.5, 0.5 0.5, 0.5 nan, 0.5 0.5, 0.5 1.5, 0.5 nan, -0.5 1.5, 0.5 1.5, 0.5 nan");
  EXPECT_TRUE(series_of(figure.panels[1], "outline: not ok").points.empty());
}

TEST(Map, MarksOfFineCellsDoNotOverlap) {
  const auto marks = [](const SweepResults& results) {
    return series_of(map_of(results).panels[0], "inadmissible").points;
  };
  EXPECT_EQ(marks(two_keys()).size(), 14u);  // all cells but the one that is ok
  const auto fine = marks(tests::made_up_sweep(
      {{"system.restitution", "0.6:1:60"}, {"impulse.rate", "log:0.1:10:60"}}));
  EXPECT_LT(fine.size(), 700u);
  EXPECT_GT(fine.size(), 300u);
}

TEST(Map, LeavesCellsWithoutADistanceEmpty) {
  auto results = two_keys();
  results.points[3].methods[tests::made_up_moment] = tests::made_up_failure();
  results.points.erase(results.points.begin());  // a missing point
  const auto figure = map_of(results);
  const auto& values = figure.panels[1].map->values;
  EXPECT_EQ(std::ranges::count_if(values, [](double value) { return std::isnan(value); }), 2);
  EXPECT_TRUE(std::isnan(values[0]));
  const std::string entry = "title 'white: no distance'";
  EXPECT_NE(report::make_gnuplot_script(figure, "sweep-map").find(entry), std::string::npos);
  EXPECT_EQ(report::make_gnuplot_script(map_of(two_keys()), "sweep-map").find(entry),
            std::string::npos);
}

TEST(Map, MarksTheReferenceWhereItIsNotAlwaysTheSame) {
  auto results = two_keys();
  EXPECT_TRUE(series_of(map_of(results).panels[2], "the reference").points.empty());
  results.points[0].reference = "fd-white";
  EXPECT_EQ(points_of(map_of(results).panels[2], "the reference"), "0 0");
}

TEST(Map, OfScatteredPointsHasDiscs) {
  const auto figure = map_of(tests::made_up_sweep(
      tests::made_up_plan({{"system.restitution", "0.6:1"}, {"impulse.rate", "log:0.1:10"}},
                          SweepPlanDesign::sobol, 12)));
  const auto& panel = figure.panels[1];
  EXPECT_EQ(panel.map->discs.size(), 12u);
  EXPECT_TRUE(panel.map->values.empty());
  EXPECT_TRUE(panel.y.is_logarithmic);
  EXPECT_TRUE(series_of(panel, "1 %").points.empty());
}

}  // namespace
}  // namespace fpkcheck::sweep
