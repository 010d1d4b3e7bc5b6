#include <gtest/gtest.h>

#include "made_up_studies.hpp"
#include "report/figure/drawing.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::study {
namespace {

using tests::contains;

TEST(GridFigure, HasALineForEachSchemeEachFormulationAndTheSimulation) {
  const std::string script = figure(tests::made_up_grid_study(), "study-grid");
  EXPECT_TRUE(contains(script, "'finite volumes, order 3'"));
  EXPECT_TRUE(contains(script, "'finite volumes, order 5'"));
  EXPECT_TRUE(contains(script, "'closure, gaussian, n = 2, 4, ..'"));
  EXPECT_TRUE(contains(script, "'closure, moment, n = 2, 4, ..'"));
  EXPECT_TRUE(contains(script, "'simulation'"));
  // Solutions that are not ok are not drawn: one point of the first formulation remains.
  EXPECT_TRUE(contains(script, "$other_0 << EOD\n0 6.7 0.0044 0.03\nEOD\n")) << script;
  // Lines have the colours of their methods.
  EXPECT_TRUE(contains(script, "NaN with linespoints lc rgb '#D55E00'"));
  EXPECT_TRUE(contains(script, "NaN with linespoints lc rgb '#CC79A7'"));
}

TEST(GridFigure, HasALegendEntryForEveryLine) {
  for (const auto width : {report::FigureWidth::screen, report::FigureWidth::one_column}) {
    const auto script = figure(tests::made_up_grid_study(), "study-grid", width);
    EXPECT_GT(tests::plot_elements(script).size(), 10u);
    const auto untold = tests::elements_without_entry(script);
    EXPECT_TRUE(untold.empty()) << untold.front();
  }
}

TEST(GridFigure, CanBeDrawn) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = report::write_pictures(directory.path(), "study-grid",
                                               figure(tests::made_up_grid_study(), "study-grid"),
                                               {.formats = {report::FigureFormat::svg}}, "gnuplot");
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string svg = tests::contents(directory.path() / "study-grid.svg");
  for (const char* text : {"(a) grids: displacement", "(d) error against cost", "simulation"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
}

TEST(GridFigure, IsEmptyWhereThereIsNothingToDraw) {
  auto study = tests::made_up_grid_study();
  for (auto& row : study.rows) row.l1.reset();
  study.others.clear();
  EXPECT_EQ(figure(study, "study-grid"), "");
}

}  // namespace
}  // namespace fpkcheck::study
