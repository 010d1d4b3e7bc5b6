#include "compare/figure/script.hpp"

#include <gtest/gtest.h>

#include <set>

#include "compare/figure/gnuplot.hpp"
#include "compare/report.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

SavedRun made_up_run(const std::string& name = "case1") {
  return make_run("fpkcheck run", std::vector<CaseReport>{tests::full_report(name)});
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

FigureContent content_of(const SavedRun& run) {
  return figure_content(run.summary["cases"][0], run.marginals);
}

TEST(Figure, SubtractsTheFullEquationElseTheSimulation) {
  SavedRun run = made_up_run();
  EXPECT_EQ(content_of(run).reference, "fd-kf");
  const FigureContent content = content_of(run);
  for (const auto& drawn : content.sides[1].curves) {
    for (const auto& kf : run.marginals) {
      if (kf.solution != "fd-kf" || kf.variable != "ydot") continue;
      EXPECT_EQ(drawn.difference[70], drawn.curve->density[70] - kf.density[70]);
    }
  }
  auto& solutions = run.summary["cases"][0]["solutions"];
  solutions[6]["status"] = "not_converged";
  EXPECT_EQ(content_of(run).reference, "mcs");
  solutions[7]["status"] = "failed";
  const auto without = content_of(run);
  EXPECT_EQ(without.reference, "");
  EXPECT_FALSE(contains(figure_script(run.summary["cases"][0], without, "s"), "difference from"));
}

TEST(Figure, RangesFollowOnlySolutionsThatAreOk) {
  SavedRun run = made_up_run();
  const double before = content_of(run).sides[0].ranges.largest_density;
  for (auto& curve : run.marginals) {
    if (curve.solution == "epc-gaussian-n4") curve.density.assign(curve.density.size(), 50);
  }
  EXPECT_EQ(content_of(run).sides[0].ranges.largest_density, before);
}

TEST(Figure, RangesHoldWhatTheLogarithmShows) {
  const SavedRun run = made_up_run();
  const FigureContent content = content_of(run);
  for (const auto& side : content.sides) {
    for (const auto& drawn : side.curves) {
      if (drawn.solution->at("status") != "ok") continue;
      for (std::size_t k = 0; k < drawn.curve->density.size(); ++k) {
        if (drawn.curve->density[k] <= 1e-6) continue;
        EXPECT_GE(drawn.curve->abscissa[k], side.ranges.logarithmic_from);
        EXPECT_LE(drawn.curve->abscissa[k], side.ranges.logarithmic_to);
      }
    }
  }
}

TEST(Figure, DrawsTheSimulationAsPointsOnTop) {
  const auto run = made_up_run();
  EXPECT_TRUE(content_of(run).sides[0].curves.back().style.as_points);
}

TEST(Figure, NoTwoCurvesLookTheSame) {
  std::vector<nlohmann::ordered_json> solutions;
  for (const char* id : {"fd-white", "fd-km4", "fd-km4-delta", "fd-kf", "mcs"}) {
    const std::string name = id;
    solutions.push_back({{"id", name}, {"method", name.substr(0, name.find('-'))}});
  }
  for (const char* formulation : {"gaussian", "moment"}) {
    for (const int order : {2, 4, 6, 8, 10, 12}) {
      solutions.push_back({{"method", "epc"}, {"order", order}, {"formulation", formulation}});
    }
  }
  std::set<std::string> looks;
  for (const auto& solution : solutions) {
    const CurveStyle style = curve_style(solution);
    looks.insert(style.colour + style.dash + (style.as_points ? "o" : "-"));
  }
  EXPECT_EQ(looks.size(), solutions.size());
}

TEST(GnuplotString, QuotesAndEscapes) {
  EXPECT_EQ(gnuplot_string("it's"), "'it''s'");
  // A string ends with its line: what came after would be a command.
  EXPECT_EQ(gnuplot_string("x'\nsystem(\"rm\")\r#\x1b"), "'x'' system(\"rm\") # '");
  EXPECT_EQ(gnuplot_literal("a_b^{c}"), "'a\\_b\\^\\{c\\}'");
}

}  // namespace
}  // namespace fpkcheck::compare
