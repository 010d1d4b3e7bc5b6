#include "report/figure/density_figure.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "modified_case.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;
using tests::solution_of;
using Texts = std::vector<std::string>;

Figure figure_of(const results::CaseResult& case_result, FigureWidth width = FigureWidth::screen) {
  return density_figure(case_result.problem, figure_content(case_result), width);
}

Texts titles(const Figure& figure) {
  Texts all;
  for (const auto& panel : figure.panels) all.push_back(panel.letter + ' ' + panel.title);
  return all;
}

const FigureSeries* series_of(const FigurePanel& panel, const std::string& start) {
  const auto found = std::ranges::find_if(
      panel.series, [&](const FigureSeries& series) { return series.name.starts_with(start); });
  return found == panel.series.end() ? nullptr : &*found;
}

TEST(DensityFigure, HasTheLetteredPanelsOfThePaperWithEveryCurve) {
  const auto case_result = made_up_case();
  const auto figure = figure_of(case_result);
  EXPECT_EQ(titles(figure), (Texts{"a displacement", "b displacement, logarithmic",
                                   "e displacement, difference from mcs", "c velocity",
                                   "d velocity, logarithmic", "f velocity, difference from mcs"}));
  EXPECT_EQ(figure.columns, 3);
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const auto& panel = figure.panels[k];
    EXPECT_EQ(panel.y.is_logarithmic, k % 3 == 1);
    for (const auto& solution : case_result.solutions) {
      const bool is_drawn = case_result.curve(solution.id(), transform::Variable::y) != nullptr;
      EXPECT_EQ(series_of(panel, solution.id()) != nullptr, is_drawn) << solution.id();
    }
    EXPECT_NE(series_of(panel, "epc-gaussian-n4 (inadmissible)"), nullptr);
  }
}

TEST(DensityFigure, HasTheStylesOfTheMethods) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").identity.plot_style = {
      .colour = "#123456", .dash = "(10,4)", .width = 2.5};
  const auto figure = figure_of(case_result);
  const FigureSeries& line = *series_of(figure.panels[1], "fd-kf");
  EXPECT_EQ(line.colour, "#123456");
  EXPECT_EQ(line.dash, "(10,4)");
  EXPECT_EQ(line.line_width, 2.5);
  EXPECT_EQ(line.symbol, "");  // closures alone have marks
  EXPECT_GT(series_of(figure.panels[1], "epc-gaussian-n2")->mark_step, 1u);
  // The simulation has hollow points, with intervals except on the linear axis.
  const FigureSeries &linear = *series_of(figure.panels[0], "mcs, with 95 % intervals"),
                     &logarithmic = *series_of(figure.panels[1], "mcs, with 95 % intervals");
  EXPECT_EQ(linear.dash, "");
  EXPECT_EQ(linear.symbol, "circle-open");
  EXPECT_TRUE(std::isnan(linear.points[0].upper));
  EXPECT_GT(logarithmic.points[0].upper, logarithmic.points[0].lower);
  EXPECT_LE(logarithmic.points.size(), 70u);
}

TEST(DensityFigure, HasALegendEntryForEachStyle) {
  auto smooth = tests::made_up_case_with_control_variates();
  auto marked = made_up_case();
  for (auto* case_result : {&smooth, &marked}) {
    solution_of(*case_result, "epc-gaussian-n2").identity.plot_style.symbol = "square";
    for (const auto width :
         {FigureWidth::screen, FigureWidth::two_columns, FigureWidth::one_column}) {
      const auto script = figure_script(figure_of(*case_result, width), "stem", width);
      EXPECT_GT(tests::plot_elements(script).size(), 20u);
      EXPECT_EQ(tests::elements_without_entry(script), Texts());
    }
  }
}

TEST(DensityFigure, InOneColumnHasLogarithmsAndDifferencesOnly) {
  EXPECT_EQ(titles(figure_of(made_up_case(), FigureWidth::one_column)),
            (Texts{" displacement", " difference from mcs", " velocity", " difference from mcs"}));
}

TEST(DensityFigure, HasDifferencesWhereThereIsAReference) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").status = transform::Status::failed;
  solution_of(case_result, "mcs").status = transform::Status::failed;
  case_result.assess();
  EXPECT_EQ(figure_of(case_result).panels.size(), 4u);
}

// A summary from an untrusted source must not inject commands: an id is plain text and cannot end
// its line, and an invalid style is quoted or replaced.
TEST(DensityFigure, RunsNoCommandOfAnIdOrAStyle) {
  auto case_result = made_up_case();
  const std::string id = "x\nsystem 'touch PWNED'\n#";
  for (auto& curve : case_result.curves) {
    if (curve.solution == "mcs") curve.solution = id;
  }
  solution_of(case_result, "mcs").identity.id = id;
  case_result.assess();
  auto& plot_style = solution_of(case_result, "fd-kf").identity.plot_style;
  plot_style.colour = "x'; system('rm')\n#";
  plot_style.dash = "solid; system('rm')";
  const std::string script = figure_script(figure_of(case_result), "stem");
  EXPECT_TRUE(contains(script, "difference from x system ''touch PWNED'' #"));
  EXPECT_TRUE(contains(script, "linecolor rgb 'x''; system(''rm'') #' dashtype solid"));
  EXPECT_FALSE(contains(script, "\nsystem"));
}

}  // namespace
}  // namespace fpkcheck::report
