#include "report/figure/case_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "case_with_sources.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "saved_run.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using Texts = std::vector<std::string>;

Texts titles(const Figure& figure) {
  Texts all;
  for (const auto& panel : figure.panels) all.push_back(panel.title);
  return all;
}

TEST(ErrorSourceFigure, HasAMapForEachMomentOfTheClosestClosureAndTheEquation) {
  const auto case_result = tests::case_with_sources();
  // On a screen each density has a column, on paper a row.
  EXPECT_EQ(titles(error_source_figure(case_result)),
            (Texts{"E[{/:Italic y}²] of epc-gaussian-n6: +1.0 × 10^{−3}",
                   "E[{/:Italic y}²] of fd-kf: +1.0 × 10^{−6}",
                   "E[{/:Italic y}'²] of epc-gaussian-n6: −2.0 × 10^{−3}",
                   "E[{/:Italic y}'²] of fd-kf: −2.0 × 10^{−6}"}));
  EXPECT_EQ(titles(error_source_figure(case_result, FigureWidth::one_column))[1],
            "E[{/:Italic y}'²] of epc-gaussian-n6: −2.0 × 10^{−3}");
  EXPECT_TRUE(error_source_figure(tests::made_up_case()).panels.empty());
}

TEST(ErrorSourceFigure, PlacesEqualStepsByTheSignedRoot) {
  for (const auto& panel : error_source_figure(tests::case_with_sources()).panels) {
    const auto& axis = panel.map->colour_axis;
    EXPECT_TRUE(axis.label.starts_with("error per area")) << axis.label;
    std::vector<std::pair<double, double>> tics;  // value and position
    for (const auto& tic : axis.tics) {
      const bool is_negative = tic.label.starts_with("−");
      const double value = std::stod(is_negative ? tic.label.substr(3) : tic.label);
      tics.emplace_back(is_negative ? -value : value, tic.place);
    }
    ASSERT_GE(tics.size(), 5u);
    const double step = tics[1].first - tics[0].first;
    const auto [last, top] = tics.back();
    EXPECT_LE(top, 1);
    EXPECT_GT(top * top * (1 + step / last), 1);  // a further step would exceed the bar
    for (std::size_t k = 0; k < tics.size(); ++k) {
      const auto [value, place] = tics[k];
      EXPECT_NEAR(value - tics.front().first, static_cast<double>(k) * step, 1e-9);
      EXPECT_NEAR(place, std::copysign(top * std::sqrt(std::abs(value / last)), value), 1e-12);
    }
  }
}

TEST(ErrorSourceFigure, OfThePageHasAllThatHaveTheirSourcesClosuresFirst) {
  const auto case_result = tests::case_with_sources();
  const auto figure = error_source_page_figure(case_result);
  ASSERT_EQ(figure.panels.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& panel = figure.panels[k];
    const auto& map = *panel.map;
    EXPECT_EQ(panel.id, k < 2 ? "errors-y2" : "errors-v2");
    EXPECT_EQ(panel.choice, k % 2 == 0 ? "epc-gaussian-n6" : "fd-kf");
    EXPECT_EQ(
        map.root_scale,
        *std::ranges::max_element(
            case_result.moment_error_source(panel.choice, k < 2 ? "y2" : "v2")->density.averages,
            {}, [](double value) { return std::abs(value); }) *
            (k < 2 ? 1 : -1));
    // The largest value is at the wall, at y' > 0.
    const auto largest =
        std::ranges::find_if(map.values, [](double value) { return std::abs(value) == 1; });
    ASSERT_NE(largest, map.values.end());
    const auto place = static_cast<std::size_t>(largest - map.values.begin());
    EXPECT_EQ(place % map.columns, 0u);
    EXPECT_GE(place / map.columns, map.values.size() / map.columns / 2);
    EXPECT_EQ(*largest > 0, k < 2);
  }
  EXPECT_EQ(figure.panels[2].caption, "E[y′²]: error −0.0020");
}

TEST(ErrorSourceFigure, HasNoPanelsWithoutSourcesOrOnDifferentCells) {
  EXPECT_TRUE(error_source_page_figure(tests::made_up_case()).panels.empty());
  auto case_result = tests::case_with_sources();
  case_result.error_sources[1].density.y_edges.back() += 1;
  EXPECT_TRUE(error_source_page_figure(case_result).panels.empty());
  EXPECT_TRUE(error_source_figure(case_result).panels.empty());
}

// A summary from an untrusted source must not inject commands.
TEST(ErrorSourceFigure, RunsNoCommandOfAnId) {
  const std::string id = "x`touch PWNED`\"_'";
  const auto script =
      make_gnuplot_script(error_source_figure(tests::case_with_sources(id)), "stem");
  EXPECT_TRUE(tests::contains(
      script, "set title say('(b) E[{/:Italic y}²] of x`touch PWNED`\"\\_\'\': +1.0 × 10^{−6}', "))
      << script.substr(0, 400);
}

TEST(ErrorSourceFigure, IsDrawn) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "no gnuplot";
  const tests::TemporaryDirectory directory;
  const auto warnings = write_script_and_draw(
      directory.path(), "stem",
      make_gnuplot_script(error_source_figure(tests::case_with_sources()), "stem"), {}, "gnuplot");
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  EXPECT_TRUE(std::filesystem::exists(directory.path() / "stem.png"));
}

}  // namespace
}  // namespace fpkcheck::report
