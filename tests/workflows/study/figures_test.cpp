#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "made_up_studies.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"
#include "transient/made_up_transient.hpp"
#include "workflows/study/study_record.hpp"

namespace fpkcheck::study {
namespace {

using report::FigurePanel;
using report::FigureSeries;
using Names = std::vector<std::string>;

Names names_in(const FigurePanel& panel) {
  Names names;
  for (const auto& series : panel.series) names.push_back(series.name);
  return names;
}

// The coordinates of the points of a series as text: "2 0.004; 4 0.026; ".
std::string points_text(const FigureSeries& series) {
  std::string text;
  for (const auto& point : series.points) text += fmt::format("{:g} {:g}; ", point.x, point.y);
  return text;
}

void expect_drawn(const report::Figure& figure, const Names& texts) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = report::write_script_and_draw(
      directory.path(), "stem", report::make_gnuplot_script(figure, "stem"),
      {.formats = {report::FigureFormat::svg}}, "gnuplot");
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string svg = tests::contents(directory.path() / "stem.svg");
  for (const auto& text : texts) EXPECT_TRUE(tests::contains(svg, text)) << text;
}

TEST(StudySeries, OfNeighboursWithANameHaveTheStyleOfTheMiddle) {
  const auto study = tests::made_up_order_study();
  const auto all = make_empty_figure_series(
      study.rows, [](const ClosureOrderStudyRow& row) { return row.formulation; },
      [](const ClosureOrderStudyRow& row) -> std::optional<report::FigurePoint> {
        if (row.order == 8) return std::nullopt;
        return report::FigurePoint{.x = static_cast<double>(row.order), .y = 1};
      });
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(points_text(all[0]), "2 1; 4 1; ");
  EXPECT_EQ(all[1].name, "moment");
  EXPECT_EQ(points_text(all[1]), "4 1; 6 1; ");
  EXPECT_EQ(all[1].colour, study.rows[3].solution.identity.plot_style.colour);
}

TEST(OrderFigure, DrawsFormulationsInTheirColoursAndOpensMarksThatAreNotOk) {
  const auto drawn = study_figure(tests::made_up_order_study());
  ASSERT_EQ(drawn.panels.size(), 3u);
  EXPECT_EQ(names_in(drawn.panels[0]), (Names{"gaussian", "moment"}));
  const auto &gaussian = drawn.panels[0].series[0], &moment = drawn.panels[1].series[1];
  EXPECT_EQ(points_text(gaussian), "2 0.004; 4 0.026; ");
  EXPECT_FALSE(gaussian.points[0].open);
  EXPECT_TRUE(gaussian.points[1].open);
  EXPECT_EQ(gaussian.colour, "#D55E00");
  EXPECT_EQ(moment.colour, "#CC79A7");
  EXPECT_EQ(points_text(moment), "4 0.016; 6 0.004; ");
  EXPECT_TRUE(drawn.panels[0].y.is_logarithmic);
  EXPECT_TRUE(drawn.panels[0].y.label.ends_with(" to fd-kf"));
  EXPECT_EQ(names_in(drawn.panels[2]), (Names{"branch: gaussian n = 8", "fold of a branch"}));
  EXPECT_EQ(points_text(drawn.panels[2].series[0]), "0 1; 0.655 2.5; ");
  EXPECT_EQ(points_text(drawn.panels[2].series[1]), "0.655 2.5; ");
  expect_drawn(drawn, {"(a) displacement", "(c) branches", "moment", "fd-kf", "open: not ok"});
}

TEST(OrderFigure, HasNoThirdPanelWithoutABranch) {
  auto study = tests::made_up_order_study();
  study.rows[2].solution.metrics.clear();
  EXPECT_EQ(study_figure(study).panels.size(), 2u);
}

TEST(GridFigure, HasALineForEachSchemeEachFormulationAndTheSimulation) {
  const auto drawn = study_figure(tests::made_up_grid_study());
  ASSERT_EQ(drawn.panels.size(), 4u);
  const std::string slope = "slope of the scheme's order";
  EXPECT_EQ(names_in(drawn.panels[0]),
            (Names{"finite volumes, order 3", "finite volumes, order 5", slope, slope}));
  EXPECT_EQ(names_in(drawn.panels[3]), (Names{"finite volumes, order 3", "finite volumes, order 5",
                                              "closure, gaussian, n = 2, 4, ..",
                                              "closure, moment, n = 2, 4, ..", "simulation"}));
  // Solutions that are not ok are not drawn: one point of the first formulation remains.
  EXPECT_EQ(points_text(drawn.panels[2].series[2]), "6.7 0.0044; ");
  EXPECT_EQ(points_text(drawn.panels[3].series[2]), "6.7 0.03; ");
  // The slope begins at the first grid that is ok, with refinement 1, and ends at 1.5.
  EXPECT_EQ(points_text(drawn.panels[0].series[2]), "1 0.00555556; 1.5 0.00164609; ");
  // Lines have the colours of their methods.
  EXPECT_EQ(drawn.panels[2].series[2].colour, "#D55E00");
  EXPECT_EQ(drawn.panels[2].series[3].colour, "#CC79A7");
  for (const auto& panel : drawn.panels) {
    EXPECT_TRUE(panel.x.is_logarithmic && panel.y.is_logarithmic);
  }
  expect_drawn(drawn, {"(a) grids: displacement", "(d) error against cost", "simulation"});
}

TEST(GridFigure, IsEmptyWhereThereIsNothingToDraw) {
  auto study = tests::made_up_grid_study();
  for (auto& row : study.rows) row.l1.reset();
  study.others.clear();
  EXPECT_TRUE(study_figure(study).panels.empty());
}

TEST(TransientFigure, IsDrawnOfBothMarginals) {
  const auto run = tests::made_up_transient(600);
  const auto drawn = transient_figure(run);
  ASSERT_EQ(drawn.panels.size(), 2u);
  for (const auto& panel : drawn.panels) {
    ASSERT_TRUE(panel.map);
    EXPECT_EQ(panel.map->columns, 400u);
    EXPECT_EQ(panel.map->values.size(), 400u * 200u);
    EXPECT_EQ(panel.x.to, run.result.snapshots.back().time);
  }
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = write_transient_files(
      directory.path(), run, {.formats = {report::FigureFormat::png, report::FigureFormat::svg}});
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const auto stem = directory.path() / "figures" / "transient-it_s_a__case_";
  EXPECT_TRUE(tests::contents(stem.string() + ".png").starts_with("\x89PNG\r\n\x1a\n"));
  const std::string svg = tests::contents(stem.string() + ".svg");
  for (const char* text : {"it's a_{case}: c = 0.1", "(a) displacement", "(b) velocity"}) {
    EXPECT_TRUE(tests::contains(svg, text)) << text;
  }
}

}  // namespace
}  // namespace fpkcheck::study
