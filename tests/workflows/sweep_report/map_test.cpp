#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <gtest/gtest.h>

#include <iterator>
#include <set>

#include "made_up_sweep.hpp"
#include "report/figure/gnuplot.hpp"
#include "saved_run.hpp"
#include "workflows/sweep/report/figure/map_data.hpp"
#include "workflows/sweep/report/figure/status_mark.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;
using transform::Status;

std::string map_of(const SweepResults& results) {
  return map_script(SweepView(results), "sweep-map");
}

SweepResults two_keys() {
  return tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates});
}

TEST(Map, HasAPanelForEachMethodButTheReference) {
  const std::string script = map_of(two_keys());
  for (const char* id : {"epc-gaussian-n4", "epc-moment-n4", "fd-white"}) {
    EXPECT_TRUE(contains(script, fmt::format("set title '{}'", id))) << script;
  }
  EXPECT_FALSE(contains(script, "'fd-kf'"));
  // The larger distance of both marginals, for the first values of the keys.
  EXPECT_TRUE(contains(script, "$map_1 << EOD\n0 0 0.2\n")) << script;
  EXPECT_TRUE(contains(script, "set colorbox"));
}

TEST(Map, HasContoursWhereDistancesCrossOneAndFivePerCent) {
  const std::string script = map_of(two_keys());
  EXPECT_TRUE(contains(script, "set table $contour_one_1")) << script;
  EXPECT_TRUE(contains(script, "$contour_five_1 using 1:2 with lines"));
  EXPECT_TRUE(contains(script, "title say('1 %'"));
  EXPECT_TRUE(contains(script, "title say('5 %'"));
  // The constant 0.03 is on one side of each level.
  EXPECT_FALSE(contains(script, "$contour_one_2"));
  EXPECT_FALSE(contains(script, "$contour_five_2"));
}

TEST(Map, MarksEachStatusByADistinctShape) {
  auto results = two_keys();
  std::set<int> types;
  std::size_t point = 0;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    results.points[point++].methods[tests::made_up_moment].status = status;
    if (status != Status::ok) types.insert(point_type(status));
  }
  EXPECT_EQ(types.size(), std::size(transform::kStatusNames) - 1);
  EXPECT_FALSE(types.contains(kReferenceMark));
  const std::string script = map_of(results);
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    const bool is_marked = contains(script, fmt::format("$mark_1_{} using", point_type(status)));
    EXPECT_EQ(is_marked, status != Status::ok) << name;
    EXPECT_EQ(contains(script,
                       fmt::format("title '{}'", report::escape_enhanced_text(std::string(name)))),
              status != Status::ok)
        << name;
  }
}

TEST(Map, OutlinesCellsThatAreNotOk) {
  const std::string script = map_of(two_keys());
  // For gaussian the cell (0, 1) alone is ok.
  const auto begin = script.find("$outline_0 << EOD\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string outline = script.substr(begin, script.find("EOD\n", begin + 18) - begin);
  EXPECT_TRUE(contains(outline, "0.5 0.5\n0.5 1.5\n")) << outline;
  EXPECT_TRUE(contains(outline, "-0.5 0.5\n0.5 0.5\n")) << outline;
  EXPECT_EQ(std::ranges::count(outline, '\n'), 1 + 3 * 3);  // three borders within the map
  EXPECT_FALSE(contains(script, "$outline_1"));
}

TEST(Map, MarksOfFineCellsDoNotOverlap) {
  const auto results = two_keys();
  const SweepView view(results);
  const MapData map(view);
  const auto marks = [&](std::size_t across, std::size_t up) {
    std::set<int> types;
    const std::string text = map.mark_blocks(tests::made_up_gaussian, across, up, types);
    EXPECT_EQ(types, std::set{point_type(Status::inadmissible)});
    return std::ranges::count(text, '\n') - 2;  // minus the first and last line of the block
  };
  EXPECT_EQ(marks(20, 20), 14);  // all cells but the one that is ok
  EXPECT_EQ(marks(1, 1), 1);
  EXPECT_EQ(marks(2, 3), 6);
}

TEST(Map, LeavesCellsWithoutADistanceEmpty) {
  auto results = two_keys();
  EXPECT_FALSE(contains(map_of(results), "white: no distance"));
  results.points[3].methods[tests::made_up_moment] = tests::made_up_failure();
  results.points.erase(results.points.begin());  // a missing point
  const std::string script = map_of(results);
  EXPECT_TRUE(contains(script, "$map_1 << EOD\n0 0 NaN\n1 0 NaN\n2 0 0.")) << script;
  EXPECT_TRUE(contains(script, "title 'white: no distance'"));
}

TEST(Map, MarksTheReferenceWhereItIsNotAlwaysTheSame) {
  auto results = two_keys();
  EXPECT_FALSE(contains(map_of(results), "'the reference'"));
  results.points[0].reference = "fd-white";
  const std::string script = map_of(results);
  EXPECT_TRUE(contains(script, "$mark_2_6 << EOD\n0 0\nEOD\n")) << script;
  EXPECT_TRUE(contains(script, "title 'the reference'"));
}

TEST(Map, OfScatteredPointsHasDiscs) {
  const auto results = tests::made_up_sweep(tests::made_up_plan(
      {{"system.restitution", "0.6:1"}, {"impulse.rate", "log:0.1:10"}}, PlanDesign::sobol, 12));
  const std::string script = map_of(results);
  EXPECT_TRUE(contains(script, "$map_1 using 1:2:3 with points pt 7")) << script;
  EXPECT_TRUE(contains(script, "set logscale y"));
  EXPECT_TRUE(contains(script, "behind fc"));
  EXPECT_FALSE(contains(script, "contour"));
  EXPECT_FALSE(contains(script, "with image"));
}

}  // namespace
}  // namespace fpkcheck::sweep
