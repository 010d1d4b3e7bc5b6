#include "report/figure/case_figures.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "../page/made_up_page.hpp"
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
  return density_figure(case_result.problem, density_content_for_picture(case_result), width);
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
      const bool is_drawn =
          case_result.marginal_curve(solution.id(), transform::StateVariable::y) != nullptr;
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
  // The simulation has hollow points with intervals.
  const FigureSeries &linear = *series_of(figure.panels[0], "mcs"),
                     &logarithmic = *series_of(figure.panels[1], "mcs");
  EXPECT_EQ(linear.dash, "");
  EXPECT_EQ(linear.symbol, "circle-open");
  EXPECT_EQ(linear.note, ", with 95 % intervals");
  EXPECT_GT(linear.points[0].upper, linear.points[0].lower);
  EXPECT_GT(logarithmic.points[0].upper, logarithmic.points[0].lower);
  EXPECT_LE(logarithmic.points.size() / logarithmic.mark_step, 70u);
}

TEST(DensityFigure, HasALegendEntryForEachStyle) {
  auto smooth = tests::made_up_case_with_control_variates();
  auto marked = made_up_case();
  for (auto* case_result : {&smooth, &marked}) {
    solution_of(*case_result, "epc-gaussian-n2").identity.plot_style.symbol = "square";
    for (const auto width :
         {FigureWidth::screen, FigureWidth::two_columns, FigureWidth::one_column}) {
      const auto script = make_gnuplot_script(figure_of(*case_result, width), "stem", width);
      EXPECT_GT(tests::plot_elements(script).size(), 20u);
      EXPECT_EQ(tests::elements_without_entry(script), Texts());
    }
  }
}

TEST(DensityFigure, IsAPlotOfThePageForEachMarginal) {
  const auto case_result = tests::whole_case();
  const std::set<std::string> visible{"epc-gaussian-n6", "fd-kf", "mcs"};
  const auto figure =
      density_figure(case_result.problem, density_content_for_page(case_result, visible));
  ASSERT_EQ(figure.panels.size(), 6u);
  for (std::size_t k = 0; k < 6; ++k) {
    const auto& panel = figure.panels[k];
    EXPECT_EQ(panel.id, k < 3 ? "density-y" : "density-ydot");
    std::set<std::string> groups, shown;
    for (const auto& series : panel.series) {
      EXPECT_EQ(case_result.solutions.at(series.rank).id(), series.group);
      EXPECT_FALSE(series.points.empty()) << series.name;
      groups.insert(series.group);
      if (!series.is_hidden) shown.insert(series.group);
    }
    EXPECT_EQ(groups.size(), 7u);
    EXPECT_EQ(shown, visible);
  }
  EXPECT_EQ(figure.panels[0].caption,
            "Displacement y: difference from fd-kf; logarithm of the density; density");
}

TEST(DensityFigure, HasNoDifferenceOnOtherBins) {
  auto case_result = tests::whole_case();
  case_result.curves.front().abscissa.back() += 1;
  const std::string id = case_result.curves.front().solution;
  const auto figure = figure_of(case_result);
  EXPECT_FALSE(series_of(figure.panels[1], id)->points.empty());
  EXPECT_TRUE(series_of(figure.panels[2], id)->points.empty());
}

// A density that decays is shown down to 1e-7 on the page, a density between walls down to its
// minimum.
TEST(DensityFigure, BeginsTheLogarithmBelowTheData) {
  auto case_result = tests::whole_case();
  const auto bottom = [&](std::size_t panel) {
    return density_figure(case_result.problem,
                          density_content_for_page(case_result, {"fd-kf", "mcs"}))
        .panels[panel]
        .y.from;
  };
  EXPECT_NEAR(bottom(1), 1e-7, 1e-16);
  EXPECT_NEAR(figure_of(case_result).panels[1].y.from, 1e-6, 1e-15);
  for (auto& curve : case_result.curves) {
    for (double& p : curve.density) p = std::max(p, 0.35);
  }
  EXPECT_NEAR(bottom(1), 0.1, 1e-9);
  EXPECT_NEAR(bottom(4), 0.1, 1e-9);
}

TEST(DensityFigure, InOneColumnHasLogarithmsAndDifferencesOnly) {
  EXPECT_EQ(titles(figure_of(made_up_case(), FigureWidth::one_column)),
            (Texts{" displacement", " difference from mcs", " velocity", " difference from mcs"}));
}

TEST(DensityFigure, HasDifferencesWhereThereIsAReference) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").status = transform::Status::failed;
  solution_of(case_result, "mcs").status = transform::Status::failed;
  case_result.update_assessment();
  const auto figure = figure_of(case_result);
  EXPECT_EQ(figure.panels.size(), 4u);
  EXPECT_EQ(figure.panels[0].caption, "Displacement y: logarithm of the density; density");
  case_result.curves.clear();
  EXPECT_TRUE(figure_of(case_result).panels.empty());
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
  case_result.update_assessment();
  auto& plot_style = solution_of(case_result, "fd-kf").identity.plot_style;
  plot_style.colour = "x'; system('rm')\n#";
  plot_style.dash = "solid; system('rm')";
  const std::string script = make_gnuplot_script(figure_of(case_result), "stem");
  EXPECT_TRUE(contains(script, "difference from x system ''touch PWNED'' #"));
  EXPECT_TRUE(contains(script, "linecolor rgb 'x''; system(''rm'') #' dashtype solid"));
  EXPECT_FALSE(contains(script, "\nsystem"));
}

}  // namespace
}  // namespace fpkcheck::report
