#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "report/figure/script_parts.hpp"
#include "saved_run.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

std::string distances_of(const SweepResults& results) {
  return distances_script(SweepView(results), curves_layout(results.plan), "sweep-distances");
}

std::string legend_of(const std::string& script) { return script.substr(script.rfind("set key")); }

TEST(Distances, HasACurveAndALegendEntryForEachMethodButTheReference) {
  const std::string script = distances_of(tests::made_up_sweep({tests::kFiveRestitutions}));
  const std::string legend = legend_of(script);
  for (const int m : {tests::made_up_gaussian, tests::made_up_moment, tests::made_up_white}) {
    EXPECT_TRUE(contains(script, fmt::format("$curve_0_{} using 1:2:4", m))) << script;
    EXPECT_TRUE(contains(script, fmt::format("$curve_0_{} using 1:3:4", m))) << script;
  }
  for (const char* id : {"epc-gaussian-n4", "epc-moment-n4", "fd-white"}) {
    EXPECT_TRUE(contains(legend, fmt::format("title '{}'", id))) << legend;
  }
  EXPECT_FALSE(contains(script, "$curve_0_3 using 1:2:4"));
  EXPECT_FALSE(contains(legend, "fd-kf")) << legend;
  EXPECT_TRUE(contains(script, " to fd-kf'"));
}

TEST(Distances, MarksAreOpenWhereTheAnswerIsNotOk) {
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const std::string script = distances_of(results);
  const auto looks = report::series_styles(std::vector{results.plan.methods[0].identity});
  EXPECT_TRUE(contains(script, fmt::format("0.6 0.4 0.3 {} ", looks[0].open))) << script;
  EXPECT_TRUE(contains(script, fmt::format("0.7 0.4 0.3 {} ", looks[0].filled))) << script;
  EXPECT_TRUE(contains(legend_of(script), "'open: not ok'"));

  auto all_ok = results;
  for (auto& point : all_ok.points) point.methods[0].status = transform::Status::ok;
  EXPECT_FALSE(contains(legend_of(distances_of(all_ok)), "'open: not ok'"));
}

TEST(Distances, ShowErrorEstimates) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const std::string script = distances_of(results);
  EXPECT_TRUE(contains(script, "$floor_0 << EOD\n0.6 2e-05 3e-05\n")) << script;
  EXPECT_TRUE(contains(legend_of(script), "'error of the reference'"));
  EXPECT_TRUE(contains(script, "$curve_0_0 using 1:5 with linespoints"));
  EXPECT_TRUE(contains(legend_of(script), "'error estimate'"));
  for (auto& point : results.points) {
    for (auto& method : point.methods) method.error.reset();
  }
  const std::string without = distances_of(results);
  EXPECT_FALSE(contains(without, "floor"));
  EXPECT_FALSE(contains(legend_of(without), "error"));
}

TEST(Distances, HaveACrossAtTheTopWhereThereIsNoDensity) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  EXPECT_FALSE(contains(distances_of(results), "absent"));
  results.points[2].methods[tests::made_up_moment] = tests::made_up_failure();
  const std::string script = distances_of(results);
  EXPECT_TRUE(contains(script, "$absent_0_1 << EOD\n0.6 NaN\n0.7 NaN\n0.8 0.")) << script;
  EXPECT_TRUE(contains(script, "0.8 NaN NaN")) << script;  // and a gap in the curve
  EXPECT_TRUE(contains(legend_of(script), "'no density'"));
}

TEST(Distances, HaveAGapWhereAPointIsMissing) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points.erase(results.points.begin() + 3);
  EXPECT_TRUE(contains(distances_of(results), "0.9 NaN NaN"));
}

TEST(Distances, NameNoReferenceWherePointsHaveSeveral) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points[4].reference = "fd-white";
  results.points[4].methods[tests::made_up_reference].l1 = MarginalL1Pair{1e-3, 2e-3};
  const std::string script = distances_of(results);
  EXPECT_TRUE(contains(script, " to the reference'")) << script;
  EXPECT_TRUE(contains(legend_of(script), "title 'fd-kf'"));
  EXPECT_TRUE(contains(script, "1 0.001 0.002")) << script;
}

TEST(Distances, HaveARowOfPanelsForEachWord) {
  const std::string script =
      distances_of(tests::made_up_sweep({tests::kTwoLaws, tests::kFiveRestitutions}));
  EXPECT_TRUE(contains(script, "set title '(a) displacement, gaussian'")) << script;
  EXPECT_TRUE(contains(script, "set title '(d) velocity, laplace'")) << script;
  EXPECT_TRUE(contains(script, "set xlabel say('system.restitution, "));
}

TEST(Distances, OverWordsAreMarksSideBySide) {
  const std::string script = distances_of(tests::made_up_sweep({tests::kTwoLaws}));
  EXPECT_TRUE(contains(script, "'gaussian' 0, 'laplace' 1"));
  EXPECT_FALSE(contains(script, "linespoints")) << script;
  // Four methods over 0.7 of a word's width.
  EXPECT_TRUE(contains(script, "$curve_0_0 << EOD\n-0.2625 ")) << script;
  EXPECT_TRUE(contains(script, "$curve_0_1 << EOD\n-0.0875 ")) << script;
}

}  // namespace
}  // namespace fpkcheck::sweep
