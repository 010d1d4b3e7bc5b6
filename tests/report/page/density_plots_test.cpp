#include "report/page/density_plots.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::json;

Json traces(const Plot& plot) { return tests::figure_of(plot).at("data"); }

bool is_band(const Json& trace) { return trace.value("hoverinfo", "") == "skip"; }

TEST(DensityPlots, DrawEverySolutionThatHasADensityInThreeRows) {
  const auto case_result = tests::whole_case();
  const auto plots = density_plots(case_result, "case-1");
  ASSERT_EQ(plots.size(), 2u);
  EXPECT_EQ(plots[0].id, "case-1-density-y");
  EXPECT_EQ(plots[1].id, "case-1-density-ydot");
  EXPECT_EQ(plots[0].caption,
            "Displacement y: difference from fd-kf; logarithm of the density; density");
  for (const auto& plot : plots) {
    std::map<std::string, int> rows;  // curves, by solution
    std::set<std::string> shown;
    for (const auto& trace : traces(plot)) {
      const auto id = trace.at("legendgroup").get<std::string>();
      if (!is_band(trace)) ++rows[id];
      if (trace.value("visible", "") != "legendonly") shown.insert(id);
    }
    const std::map<std::string, int> expected{{"epc-gaussian-n2", 3},
                                              {"epc-gaussian-n4", 3},
                                              {"epc-gaussian-n6", 3},
                                              {"fd-white", 3},
                                              {"fd-km4", 3},
                                              {"fd-kf", 3},
                                              {"mcs", 3}};
    EXPECT_EQ(rows, expected) << plot.id;
    EXPECT_EQ(shown, (std::set<std::string>{"epc-gaussian-n6", "fd-kf", "mcs"})) << plot.id;
  }
}

// A density that decays is shown down to 1e-7, a density between walls down to its minimum.
TEST(DensityPlots, BeginTheirLogarithmBelowTheData) {
  auto case_result = tests::whole_case();
  const auto bottom = [&](std::size_t plot) {
    const auto range = tests::figure_of(density_plots(case_result, "case-1")[plot])
                           .at("layout")
                           .at("yaxis2")
                           .at("range");
    return range.at(0).get<double>();
  };
  EXPECT_NEAR(bottom(0), -7, 1e-9);
  for (auto& curve : case_result.curves) {
    for (double& p : curve.density) p = std::max(p, 0.35);
  }
  EXPECT_NEAR(bottom(0), -1, 1e-9);
  EXPECT_NEAR(bottom(1), -1, 1e-9);
}

TEST(DensityPlots, HaveThePlotStyleOfTheirSolution) {
  auto case_result = tests::whole_case();
  auto& plot_style = tests::solution_of(case_result, "epc-gaussian-n6").identity.plot_style;
  plot_style = {.colour = "#123456", .dash = "(3,4)", .width = 7};
  const auto plots = density_plots(case_result, "case-1");
  const Json line = tests::trace_of(plots[0], "epc-gaussian-n6").at("line");
  EXPECT_EQ(line, Json({{"color", "#123456"}, {"width", 7.0}, {"dash", "3px,4px"}}));
  for (const auto& trace : traces(plots[0])) {
    if (trace.at("legendgroup") != "mcs" || is_band(trace)) continue;
    EXPECT_EQ(trace.at("mode"), "markers");
  }
}

TEST(DensityPlots, LegendsHaveTheOrderOfTheTables) {
  const auto case_result = tests::whole_case();
  const auto plots = density_plots(case_result, "case-1");
  int entries = 0;
  for (const auto& trace : traces(plots[0])) {
    const auto rank = trace.at("legendrank").get<std::size_t>();
    EXPECT_EQ(case_result.solutions.at(rank).id(), trace.at("legendgroup").get<std::string>());
    entries += trace.at("showlegend").get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(entries, 7);
}

TEST(DensityPlots, HaveEveryArrayOfATrace) {
  auto case_result = tests::whole_case();
  case_result.curves.front().abscissa.back() += 1;  // bins different from those of the reference
  const auto plots = density_plots(case_result, "case-1");
  const Json figure = tests::figure_of(plots[0]), &arrays = figure.at("arrays");
  int curves = 0;
  for (const auto& trace : figure.at("data")) {
    for (const char* letter : {"x", "y"}) {
      const auto name = trace.at(letter).get<std::string>();
      ASSERT_EQ(name.front(), '@');
      EXPECT_TRUE(arrays.contains(name.substr(1))) << name;
    }
    curves += trace.at("legendgroup") == case_result.curves.front().solution ? 1 : 0;
  }
  EXPECT_EQ(curves, 2);  // no difference on different bins
}

TEST(DensityPlots, BandsOfASimulationAreInAllRows) {
  const auto plots = density_plots(tests::whole_case(), "case-1");
  std::map<std::string, int> edges;
  for (const auto& trace : traces(plots[1])) {
    if (is_band(trace)) ++edges[trace.at("yaxis")];
  }
  EXPECT_EQ(edges, (std::map<std::string, int>{{"y", 2}, {"y2", 2}, {"y3", 2}}));
}

TEST(DensityPlots, WithoutAReferenceHaveTwoRows) {
  auto case_result = tests::whole_case();
  for (const char* id : {"fd-kf", "mcs"}) {
    tests::solution_of(case_result, id).status = transform::Status::failed;
    case_result.assess();
  }
  const auto plots = density_plots(case_result, "case-1");
  EXPECT_EQ(plots[0].caption, "Displacement y: logarithm of the density; density");
  EXPECT_FALSE(tests::figure_of(plots[0]).at("layout").contains("yaxis3"));
}

TEST(DensityPlots, AreNoneWithoutCurves) {
  auto case_result = tests::whole_case();
  case_result.curves.clear();
  EXPECT_TRUE(density_plots(case_result, "case-1").empty());
}

using Ids = std::set<std::string>;

TEST(InitiallyVisible, AreTheReferencesAndTheClosestClosureOfEachFamily) {
  auto case_result = tests::whole_case();
  EXPECT_EQ(initially_visible_solutions(case_result), (Ids{"epc-gaussian-n6", "fd-kf", "mcs"}));
  tests::solution_of(case_result, "epc-gaussian-n2").identity.family = "of-another";
  EXPECT_EQ(initially_visible_solutions(case_result),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n6", "fd-kf", "mcs"}));
}

TEST(InitiallyVisible, IncludeExternalDensities) {
  auto case_result = tests::whole_case();
  tests::solution_of(case_result, "epc-gaussian-n2").identity.method = transform::kExternalFile;
  EXPECT_TRUE(initially_visible_solutions(case_result).contains("epc-gaussian-n2"));
}

TEST(InitiallyVisible, AreAllWhereThatLeavesFewerThanTwo) {
  auto case_result = tests::whole_case();
  for (auto& solution : case_result.solutions) {
    if (solution.id() != "mcs") solution.status = transform::Status::failed;
  }
  case_result.assess();
  EXPECT_EQ(initially_visible_solutions(case_result).size(), case_result.solutions.size());
}

}  // namespace
}  // namespace fpkcheck::report
