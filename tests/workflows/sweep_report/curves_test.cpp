#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"
#include "shown_figure.hpp"
#include "workflows/sweep/report/figure/figures.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;
using tests::names_in;
using tests::points_of;
using Names = std::vector<std::string>;

report::Figure distances_of(const SweepResults& results) {
  return distance_curves_figure(SweepResultsView(results));
}

report::Figure moments_of(const SweepResults& results) {
  return moment_curves_figure(SweepResultsView(results));
}

bool shows(const report::Figure& figure, const std::string& name) {
  return std::ranges::any_of(figure.panels, [&](const report::FigurePanel& panel) {
    return contains(points_of(panel, name), ".");
  });
}

TEST(Distances, HaveACurveForEachMethodButTheReference) {
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const auto figure = distances_of(results);
  ASSERT_EQ(figure.panels.size(), 2u);
  const std::string estimate = "error estimate";
  for (const auto& panel : figure.panels) {
    EXPECT_EQ(names_in(panel), (Names{"error of the reference", estimate, "epc-gaussian-n4",
                                      estimate, "epc-moment-n4", estimate, "fd-white"}));
    EXPECT_TRUE(panel.y.is_logarithmic);
    EXPECT_TRUE(panel.y.label.ends_with(" to fd-kf"));
    EXPECT_EQ(tests::series_of(panel, "epc-gaussian-n4").colour,
              results.plan.methods[0].identity.plot_style.colour);
  }
  EXPECT_EQ(points_of(figure.panels[0], "fd-white"),
            "0.6 0.03, 0.7 0.03, 0.8 0.03, 0.9 0.03, 1 0.03");
  EXPECT_EQ(points_of(figure.panels[1], "fd-white"),
            "0.6 0.02, 0.7 0.02, 0.8 0.02, 0.9 0.02, 1 0.02");
}

TEST(Distances, HaveOpenMarksWhereTheSolutionIsNotOk) {
  EXPECT_EQ(points_of(distances_of(tests::made_up_sweep({tests::kFiveRestitutions})).panels[0],
                      "epc-gaussian-n4"),
            "0.6 0.4 open, 0.7 0.4, 0.8 0.4 open, 0.9 0.4 open, 1 0.4 open");
}

TEST(Distances, ShowErrorEstimates) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const auto figure = distances_of(results);
  EXPECT_TRUE(points_of(figure.panels[0], "error of the reference").starts_with("0.6 2e-05, 0.7"));
  EXPECT_TRUE(points_of(figure.panels[1], "error of the reference").starts_with("0.6 3e-05, 0.7"));
  EXPECT_TRUE(points_of(figure.panels[0], "error estimate").starts_with("0.6 0.45, 0.7 0.45"));
  for (auto& point : results.points) {
    for (auto& method : point.methods) method.error.reset();
  }
  const auto without = distances_of(results);
  EXPECT_FALSE(contains(points_of(without.panels[0], "error of the reference"), " 2e-05"));
  EXPECT_FALSE(contains(points_of(without.panels[0], "error estimate"), " 0.45"));
}

TEST(Distances, HaveACrossAtTheTopWhereThereIsNoDensity) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  EXPECT_FALSE(shows(distances_of(results), "no density"));
  results.points[2].methods[tests::made_up_moment] = tests::made_up_failure();
  const auto figure = distances_of(results);
  const auto& panel = figure.panels[0];
  const auto& crosses = tests::series_of(panel, "no density");
  ASSERT_EQ(crosses.points.size(), 1u);
  EXPECT_EQ(crosses.points[0].x, 0.8);
  EXPECT_LT(crosses.points[0].y, panel.y.to);
  EXPECT_GT(crosses.points[0].y, 0.45);
  // The curve has a gap.
  EXPECT_TRUE(contains(points_of(panel, "epc-moment-n4"), "0.8 nan, 0.9 "));
}

TEST(Distances, HaveAGapWhereAPointIsMissing) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points.erase(results.points.begin() + 3);
  EXPECT_TRUE(contains(points_of(distances_of(results).panels[0], "fd-white"), "0.9 nan, 1 0.03"));
}

TEST(Distances, NameNoReferenceWherePointsHaveSeveral) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points[4].reference = "fd-white";
  results.points[4].methods[tests::made_up_reference].l1 = MarginalL1Values{1e-3, 2e-3};
  const auto figure = distances_of(results);
  EXPECT_TRUE(figure.panels[0].y.label.ends_with(" to the reference"));
  EXPECT_TRUE(points_of(figure.panels[0], "fd-kf").ends_with("0.9 nan, 1 0.001"));
}

TEST(Distances, HaveARowOfPanelsForEachWord) {
  const auto figure =
      distances_of(tests::made_up_sweep({tests::kTwoLaws, tests::kFiveRestitutions}));
  ASSERT_EQ(figure.panels.size(), 4u);
  EXPECT_EQ(figure.panels[0].title, "displacement, gaussian");
  EXPECT_EQ(figure.panels[3].title, "velocity, laplace");
  EXPECT_TRUE(figure.panels[3].x.label.starts_with("system.restitution, "));
}

TEST(Distances, OverWordsAreMarksSideBySide) {
  const auto figure = distances_of(tests::made_up_sweep({tests::kTwoLaws}));
  const auto& panel = figure.panels[0];
  EXPECT_EQ(tests::tics_of(panel.x), "gaussian 0, laplace 1");
  EXPECT_EQ(tests::series_of(panel, "fd-white").dash, "");
  // Four methods over 0.7 of a word's width.
  EXPECT_TRUE(points_of(panel, "epc-gaussian-n4").starts_with("-0.2625 "));
  EXPECT_TRUE(points_of(panel, "epc-moment-n4").starts_with("-0.0875 "));
  // A line connects a distance and its error estimate.
  EXPECT_TRUE(points_of(panel, "error estimate")
                  .starts_with("-0.2625 0.4, -0.2625 0.45, -0.2625 nan, 0.7375 0.4"));
}

TEST(Moments, OfAllMethodsAreDrawn) {
  const auto figure = moments_of(tests::made_up_sweep({tests::kFiveRestitutions}));
  for (const auto& panel : figure.panels) {
    EXPECT_EQ(names_in(panel), (Names{"fd-kf", "fd-white", "epc-moment-n4", "epc-gaussian-n4"}));
  }
  EXPECT_TRUE(points_of(figure.panels[0], "fd-kf").starts_with("0.6 0.4, 0.7 0.425"));
  EXPECT_TRUE(points_of(figure.panels[1], "fd-kf").starts_with("0.6 0.5, 0.7 0.525"));
}

TEST(Moments, HaveAxesThatCoverOkSolutions) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  const auto axis = [&] { return moments_of(results).panels[0].y; };
  EXPECT_NEAR(axis().from, 0.394, 1e-9);
  EXPECT_NEAR(axis().to, 0.506, 1e-9);  // not the 9
  for (auto& point : results.points) {
    for (auto& method : point.methods) method.status = transform::Status::inaccurate;
  }
  EXPECT_NEAR(axis().from, -0.116, 1e-9);
  EXPECT_NEAR(axis().to, 9.516, 1e-9);
}

TEST(Scatter, HasAPanelForEachKeyWithAllMethods) {
  const auto results =
      tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates, tests::kTwoLaws});
  const auto figure = distance_scatter_figure(SweepResultsView(results));
  ASSERT_EQ(figure.panels.size(), 3u);
  EXPECT_TRUE(figure.panels[0].x.label.starts_with("system.restitution"));
  EXPECT_TRUE(figure.panels[1].x.label.starts_with("impulse.rate"));
  EXPECT_TRUE(figure.panels[1].x.is_logarithmic);
  EXPECT_FALSE(figure.panels[2].x.is_logarithmic);
  for (const auto& panel : figure.panels) {
    EXPECT_EQ(names_in(panel), (Names{"epc-gaussian-n4", "median of epc-gaussian-n4 where ok",
                                      "epc-moment-n4", "median of epc-moment-n4 where ok",
                                      "fd-white", "median of fd-white where ok"}));
    EXPECT_TRUE(panel.y.is_logarithmic);
    EXPECT_TRUE(contains(points_of(panel, "epc-gaussian-n4"), "0.4 open"));
  }
}

TEST(Scatter, MediansAreOfOkSolutions) {
  auto results = tests::made_up_sweep(
      {{"system.restitution", "0.6,0.7"}, {"impulse.rate", "1,2,3"}, {"system.cubic", "0.1"}});
  for (std::size_t k = 0; k < 3; ++k) {
    const double l1 = std::vector{0.1, 0.5, 0.2}[k];
    results.points[k].methods[tests::made_up_white].l1 = MarginalL1Values{l1, l1 / 2};
  }
  const auto medians = [&] {
    return points_of(distance_scatter_figure(SweepResultsView(results)).panels[0],
                     "median of fd-white where ok");
  };
  EXPECT_EQ(medians(), "0.6 0.2, 0.7 0.03");
  results.points[1].methods[tests::made_up_white].status = transform::Status::inaccurate;
  results.points[2].methods[tests::made_up_white].status = transform::Status::inaccurate;
  EXPECT_EQ(medians(), "0.6 0.1, 0.7 0.03");
}

TEST(Scatter, PartsOfARangeHaveMediansOfSeveralPoints) {
  const auto results = tests::made_up_sweep(tests::made_up_plan(
      {{"system.restitution", "0.6:1"}, {"impulse.rate", "log:0.1:10"}, {"system.cubic", "0:1"}},
      SweepPlanDesign::sobol, 40));
  const auto figure = distance_scatter_figure(SweepResultsView(results));
  const auto& panel = figure.panels[0];
  EXPECT_EQ(tests::series_of(panel, "fd-white").points.size(), 40u);
  EXPECT_EQ(tests::series_of(panel, "median of fd-white where ok").points.size(), 4u);
  // One point is ok: no median.
  EXPECT_TRUE(tests::series_of(panel, "median of epc-gaussian-n4 where ok").points.empty());
}

TEST(MomentCurves, HaveTangentsWhereAMethodHasSlopes) {
  EXPECT_FALSE(shows(moments_of(tests::made_up_sweep({tests::kFiveRestitutions})), "derivative"));
  const auto with_slopes = [](const tests::KeyAndValues& axis) {
    auto results = tests::made_up_sweep({axis});
    results.points[1].methods[tests::made_up_reference].slopes = {{axis.first, 2, -1, 0.1, 0.2}};
    return moments_of(results);
  };
  // The distance of points is 0.1, and half a segment is 0.3 distances long.
  const auto figure = with_slopes(tests::kFiveRestitutions);
  const auto& segment = tests::series_of(figure.panels[0], "derivative").points;
  ASSERT_GE(segment.size(), 2u);
  EXPECT_NEAR(segment[0].x, 0.67, 1e-12);
  EXPECT_NEAR(segment[1].x, 0.73, 1e-12);
  EXPECT_NEAR(segment[1].y - segment[0].y, 2 * 0.06, 1e-12);
  EXPECT_NEAR((segment[0].y + segment[1].y) / 2, 0.425, 1e-12);
  const auto& of_velocity = tests::series_of(figure.panels[1], "derivative").points;
  EXPECT_NEAR(of_velocity[1].y - of_velocity[0].y, -0.06, 1e-12);
  // On a logarithmic axis the slope with respect to the logarithm is x df/dx, here at x = 1.
  const auto logarithmic = with_slopes(tests::kThreeRates);
  const auto& of_rate = tests::series_of(logarithmic.panels[0], "derivative").points;
  EXPECT_NEAR(std::log10(of_rate[1].x), 0.3, 1e-12);
  EXPECT_NEAR(of_rate[1].y - of_rate[0].y, 2 * 0.6 * std::log(10), 1e-12);
  EXPECT_FALSE(shows(with_slopes(tests::kTwoLaws), "derivative"));
}

}  // namespace
}  // namespace fpkcheck::sweep
