#include "report/figure/figure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/figure/run_gnuplot.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;

// A figure with every kind of series and axis, and with a map in the last panel.
Figure whole_figure() {
  const FigureSeries line{.name = "it's a_{line}",
                          .colour = "#112233",
                          .dash = "(8,4)",
                          .points = {{1, 0.1}, {2, NAN}, {3, -1}}},
      marks{.name = "marks",
            .colour = "#D55E00",
            .symbol = "square",
            .points = {{1, 0.2}, {2, 0.3, true}}},
      other_marks{.name = "shared",
                  .colour = "#0072B2",
                  .symbol = "square",
                  .points = {{1, 0.1}, {3, 0.3}},
                  .legend_colour = "#444444"},
      bars{.name = "bars",
           .colour = "#E69F00",
           .is_bars = true,
           .hatch = "/",
           .points = {{.x = 1, .y = 0.2, .lower = 0.1, .upper = 0.3, .width = 0.5},
                      {.x = 2, .y = 0.3, .open = true, .width = 0.5}}},
      nothing{.name = "nothing", .colour = "#000000", .dash = "solid"};
  const FigureAxis logarithmic{"{/:Italic y}", 0.01, 1, true},
      words{"law", 0, 4, false, 0, {{"gauss\\_ian", 1}, {"laplace", 2}}};
  return {
      .title = {"case: ", "c = 0.1"},
      .panels = {{.title = "first",
                  .x = {"{/:Italic x}", 0, 4, false, 2},
                  .y = logarithmic,
                  .series = {line, marks, bars, nothing}},
                 {.title = "second", .x = words, .y = logarithmic, .series = {line, other_marks}},
                 {.title = "map",
                  .x = {"t", 0, 2},
                  .y = {"x", -1, 1},
                  .map = FigureHeatMap{.x_range = {0, 2},
                                       .y_range = {-1, 1},
                                       .columns = 2,
                                       .values = {1, 2, 3, NAN},
                                       .colour_axis = {"p", 0, 3},
                                       .colours = {{0, "#FFFFFF"}, {1, "#000000"}}}}}};
}

TEST(FigureScript, HasALegendEntryForEveryElement) {
  for (const auto width : {FigureWidth::screen, FigureWidth::one_column}) {
    const auto script = make_gnuplot_script(whole_figure(), "stem", width);
    EXPECT_EQ(tests::elements_without_entry(script), std::vector<std::string>());
    EXPECT_TRUE(contains(script, "'open: not ok'"));
    EXPECT_FALSE(contains(script, "nothing"));  // a series without points
  }
}

TEST(FigureScript, HasGapsAndSharesDataOfEqualSeries) {
  const auto script = make_gnuplot_script(whole_figure(), "stem");
  EXPECT_TRUE(contains(script, "$data0 << EOD\n1 0.1 0\n2 NaN 0\n3 NaN 0\nEOD\n")) << script;
  EXPECT_TRUE(contains(script, "0.5 0.5 3\n1.5 0.5 NaN\n\nEOD\n")) << script;
  const auto plots = tests::plot_elements(script);
  EXPECT_EQ(
      std::ranges::count_if(plots, [](const auto& plot) { return plot.text.find("$data0 ") < 2; }),
      2);
}

TEST(FigureScript, DrawsBarsWithIntervalsAndPalerBarsThatAreOpen) {
  const auto script = make_gnuplot_script(whole_figure(), "stem");
  EXPECT_TRUE(contains(script, "<< EOD\n1 0.2 0 0.5 0.1 0.3\n2 0.3 1 0.5 0.3 0.3\nEOD\n"))
      << script;
  EXPECT_TRUE(contains(script, "pattern 4 border rgb '#E69F00' linecolor rgb '#E69F00'"));
  // 255 - 0.3 (255 - colour): E6, 9F, 00.
  EXPECT_TRUE(contains(script, "pattern 4 border rgb '#E69F00' linecolor rgb '#F7E2B2'"));
  EXPECT_TRUE(contains(script, "'* not ok'"));
}

TEST(FigureScript, LetsTheLastPanelFillItsRow) {
  const auto script = make_gnuplot_script(whole_figure(), "stem");
  const auto last = script.find("set title '(c) map'");
  ASSERT_NE(last, std::string::npos);
  const std::string right_margin = tests::first_match(script.substr(script.find("'(b) second'")),
                                                      "set rmargin at screen (\\S+)", "");
  EXPECT_TRUE(contains(script.substr(last), "set rmargin at screen " + right_margin));
  EXPECT_TRUE(contains(script.substr(last), "set lmargin at screen 0.08"));
}

TEST(FigureScript, IsDrawnInEveryFormat) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  const auto warnings = write_script_and_draw(
      directory.path(), "stem", make_gnuplot_script(whole_figure(), "stem"),
      {.formats = {FigureFormat::svg, FigureFormat::png, FigureFormat::pdf, FigureFormat::tex}},
      "gnuplot");
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const std::string svg = tests::contents(directory.path() / "stem.svg");
  for (const char* text :
       {"it's a_{line}", "gauss_ian", "(c) map", "case: c = 0.1", "marks", "shared"}) {
    EXPECT_TRUE(contains(svg, text)) << text;
  }
  EXPECT_TRUE(contains(tests::contents(directory.path() / "stem.tex"), "it's a\\_\\{line\\}"));
}

}  // namespace
}  // namespace fpkcheck::report
