#include "report/figure/case_figures.hpp"

#include <gtest/gtest.h>

#include "../external_family.hpp"
#include "../page/made_up_page.hpp"
#include "report/page/page_plots.hpp"
#include "temporary_directory.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::json;
using tests::names_in;
using tests::trace_of;
using tests::whole_case;
using Names = std::vector<std::string>;

std::vector<ReportPagePlot> order_plots(const results::CaseResult& case_result,
                                        const std::string& prefix) {
  return make_page_plots(convergence_figure(case_result), prefix);
}

std::vector<ReportPagePlot> cost_plots(const results::CaseResult& case_result,
                                       const std::string& prefix) {
  return make_page_plots(computing_time_figure(case_result), prefix);
}

std::vector<std::string> names_in(const FigurePanel& panel) {
  std::vector<std::string> names;
  for (const auto& series : panel.series) names.push_back(series.name);
  return names;
}

TEST(ConvergenceFigure, HasOneSeriesForEachFamilyByOrder) {
  const auto case_result = tests::case_with_external_family({6, 2});
  const Figure figure = convergence_figure(case_result);
  ASSERT_EQ(figure.panels.size(), 2u);
  for (const auto& panel : figure.panels) {
    EXPECT_EQ(names_in(panel), (Names{"chi", "epc-gaussian", "distance of mcs to fd-kf",
                                      "error estimate of fd-kf"}));
    const auto& chi = panel.series[0].points;
    ASSERT_EQ(chi.size(), 2u);
    EXPECT_EQ(chi[0].x, 2);
    EXPECT_EQ(chi[1].x, 6);
    for (const auto& series : panel.series) {
      for (const auto& point : series.points) {
        EXPECT_LT(panel.y.from, point.y);
        EXPECT_LT(point.y, panel.y.to);
      }
    }
  }
  EXPECT_TRUE(figure.panels[0].series[1].points[1].open);
  EXPECT_EQ(figure.panels[0].x.from, 1.5);
  EXPECT_EQ(figure.panels[0].x.to, 6.5);
  EXPECT_EQ(figure.panels[0].series[3].points[0].y, 2e-5);
}

TEST(ConvergenceFigure, HasTheSameSeriesInAScript) {
  const auto case_result = tests::case_with_external_family({6, 2});
  const std::string script = make_gnuplot_script(convergence_figure(case_result), "case1-order");
  for (const char* text :
       {"title 'chi'", "title 'epc-gaussian'", "$data0 << EOD\n2 ", "$data7 << EOD"}) {
    EXPECT_TRUE(tests::contains(script, text)) << text;
  }
}

TEST(ConvergencePicture, ExistsForAFamilyOfTwoOrders) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  results::Run run{results::current_program(""), {tests::case_with_external_family({2, 4, 6})}};
  const FigureOptions svg{.formats = {FigureFormat::svg}};
  const auto warnings = draw_pictures_of_cases(directory.path(), run, svg);
  ASSERT_TRUE(warnings.empty()) << warnings.front();
  const auto picture = directory.path() / "figures" / "case1-order.svg";
  for (const char* text : {"(a) displacement", ">chi<", "open: not ok"}) {
    EXPECT_TRUE(tests::contains(tests::contents(picture), text)) << text;
  }
  for (auto& solution : run.cases[0].solutions) solution.identity.order.reset();
  draw_pictures_of_cases(directory.path(), run, svg);
  EXPECT_FALSE(std::filesystem::exists(picture));
}

TEST(OrderPlots, HaveACurveForEachFamilyOfClosures) {
  const auto case_result = whole_case();
  const auto plots = order_plots(case_result, "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(plots[0].id, "case-1-order-y");
  EXPECT_EQ(names_in(plots[0]),
            (Names{"epc-gaussian", "distance of mcs to fd-kf", "error estimate of fd-kf"}));
  const Json curve = trace_of(plots[0], "epc-gaussian");
  EXPECT_EQ(curve.at("x"), Json({2, 4, 6}));
  EXPECT_EQ(tests::figure_of(plots[1]).at("layout").at("yaxis").at("title").at("text"),
            "<i>L</i><sub>1</sub> distance of <i>p</i>(<i>y</i>\u2032) to fd-kf");
  EXPECT_EQ(curve.at("y")[2],
            *case_result.l1_distance("epc-gaussian-n6", "fd-kf", transform::StateVariable::y));
  EXPECT_EQ(curve.at("marker").at("symbol"), Json({"circle", "circle-open", "circle"}));
  EXPECT_EQ(curve.at("customdata")[1], "epc-gaussian-n4 (inadmissible)");
  EXPECT_EQ(trace_of(plots[1], "error estimate of fd-kf").at("y")[0], 3e-5);
}

TEST(OrderPlots, HaveExternalDensitiesAtOrdersOrAsLines) {
  auto case_result = whole_case();
  for (const char* id : {"fd-white", "fd-km4"}) {
    auto& who = tests::solution_of(case_result, id).identity;
    who.method = transform::kExternalFile;
    who.role = id == std::string("fd-white") ? transform::SolutionRole::external
                                             : transform::SolutionRole::closure;
  }
  auto& with_order = tests::solution_of(case_result, "fd-km4");
  with_order.identity.order = 8;
  with_order.identity.family = "file";
  case_result.update_assessment();
  const auto plots = order_plots(case_result, "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(names_in(plots[0]), (Names{"epc-gaussian", "fd-white", "fd-km4",
                                       "distance of mcs to fd-kf", "error estimate of fd-kf"}));
  const Json level = trace_of(plots[0], "fd-white"), mark = trace_of(plots[0], "fd-km4");
  const double l1 = *case_result.l1_distance("fd-white", "fd-kf", transform::StateVariable::y);
  EXPECT_EQ(level.at("y"), Json({l1, l1}));
  EXPECT_EQ(level.at("x"), Json({1.5, 8.5}));
  EXPECT_EQ(level.at("mode"), "lines");
  EXPECT_EQ(mark.at("x"), Json({8}));
  EXPECT_EQ(mark.at("y"),
            Json({*case_result.l1_distance("fd-km4", "fd-kf", transform::StateVariable::y)}));
  EXPECT_EQ(mark.at("mode"), "markers");
}

TEST(OrderPlots, HaveACurveForAnExternalFamily) {
  const auto plots = order_plots(tests::case_with_external_family({6, 2, 4}), "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(names_in(plots[0]),
            (Names{"chi", "epc-gaussian", "distance of mcs to fd-kf", "error estimate of fd-kf"}));
  const Json curve = trace_of(plots[0], "chi");
  EXPECT_EQ(curve.at("x"), Json({2, 4, 6}));
  EXPECT_EQ(curve.at("mode"), "lines+markers");
}

TEST(OrderPlots, ShowTheErrorEstimateOfASimulation) {
  auto case_result = whole_case();
  tests::solution_of(case_result, "fd-kf").error.reset();
  case_result.update_assessment();
  EXPECT_EQ(names_in(order_plots(case_result, "case-1")[0]),
            (Names{"epc-gaussian", "distance of fd-kf to mcs", "error estimate of mcs"}));
}

TEST(OrderPlots, NeedTwoClosuresOfOneFamilyAndAReference) {
  auto case_result = whole_case();
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n4"}) {
    tests::solution_of(case_result, id).identity.family = id;
  }
  EXPECT_TRUE(order_plots(case_result, "case-1").empty());
  case_result = whole_case();
  for (const char* id : {"fd-kf", "mcs"}) {
    tests::solution_of(case_result, id).status = transform::Status::failed;
    case_result.update_assessment();
  }
  EXPECT_TRUE(order_plots(case_result, "case-1").empty());
  EXPECT_TRUE(cost_plots(case_result, "case-1").empty());
}

TEST(OrderPlots, LeaveOutAFamilyWithoutOrders) {
  auto case_result = whole_case();
  tests::solution_of(case_result, "fd-white").identity.role = transform::SolutionRole::closure;
  tests::solution_of(case_result, "fd-white").identity.family = "toy";
  case_result.update_assessment();
  const auto plots = order_plots(case_result, "case-1");
  EXPECT_TRUE(trace_of(plots[0], "toy").is_null());
  EXPECT_FALSE(trace_of(cost_plots(case_result, "case-1")[0], "toy").is_null());
}

TEST(CostPlots, ShowEverySolutionThatIsAwayFromTheReference) {
  auto case_result = whole_case();
  auto& white = tests::solution_of(case_result, "fd-white");
  white.identity.plot_style.colour = "#123456";
  white.seconds = 7;
  const auto plots = cost_plots(case_result, "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(names_in(plots[1]), (Names{"epc-gaussian", "fd", "mcs"}));
  const Json fd = trace_of(plots[0], "fd");
  EXPECT_EQ(fd.at("text"), Json({"white", "km4"}));
  EXPECT_EQ(fd.at("x"), Json({7.0, 0.42}));
  EXPECT_EQ(fd.at("marker").at("color")[0], "#123456");
  EXPECT_NE(fd.at("textposition")[0], fd.at("textposition")[1]);
}

TEST(CostPlots, ShowNamesLiterally) {
  auto case_result = whole_case();
  for (auto& solution : case_result.solutions) solution.identity.family = "<&>";
  tests::solution_of(case_result, "fd-white").identity.order = 3;
  const auto plots = cost_plots(case_result, "case-1");
  EXPECT_EQ(names_in(plots[0]), (Names{"&lt;&amp;>"}));
}

}  // namespace
}  // namespace fpkcheck::report
