#include <gtest/gtest.h>

#include "made_up_studies.hpp"
#include "report/figure/drawing.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::study {
namespace {

using tests::contains;

TEST(OrderFigure, DrawsFormulationsInTheirColoursAndSeparatesStatuses) {
  const std::string script = figure(tests::made_up_order_study(), "study-order");
  EXPECT_TRUE(contains(script, "$ok_0 << EOD\n2 0.004 0.008\nEOD\n")) << script;
  EXPECT_TRUE(contains(script, "$not_0 << EOD\n4 0.026 0.052\nEOD\n")) << script;
  EXPECT_TRUE(contains(script, "$ok_0 using 1:2 with linespoints lc rgb '#D55E00'"));
  EXPECT_TRUE(contains(script, "$ok_1 using 1:3 with linespoints lc rgb '#CC79A7'"));
  EXPECT_TRUE(contains(script, "title 'moment'"));
  EXPECT_TRUE(contains(script, " to fd-kf'"));
  EXPECT_TRUE(contains(script, "$branch_0 << EOD\n0 1 0\n0.655 2.5 1\nEOD\n"));
  EXPECT_TRUE(contains(script, "title 'branch: gaussian n = 8'"));
}

TEST(OrderFigure, HasNoThirdPanelWithoutABranch) {
  auto study = tests::made_up_order_study();
  study.rows[2].solution.metrics.clear();
  EXPECT_FALSE(contains(figure(study, "study-order"), "(c) branches"));
}

TEST(OrderFigure, HasALegendEntryForEveryLineAndMark) {
  for (const auto width : {report::FigureWidth::screen, report::FigureWidth::one_column}) {
    const auto script = figure(tests::made_up_order_study(), "study-order", width);
    EXPECT_GT(tests::plot_elements(script).size(), 8u);
    const auto untold = tests::elements_without_entry(script);
    EXPECT_TRUE(untold.empty()) << untold.front();
  }
}

TEST(OrderFigure, CanBeDrawn) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = report::write_pictures(directory.path(), "study-order",
                                               figure(tests::made_up_order_study(), "study-order"),
                                               {.formats = {report::FigureFormat::svg}}, "gnuplot");
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string svg = tests::contents(directory.path() / "study-order.svg");
  for (const char* text : {"(a) displacement", "(c) branches", "moment", "fd-kf"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
}

}  // namespace
}  // namespace fpkcheck::study
