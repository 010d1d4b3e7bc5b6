#include "report/figure/density_script.hpp"

#include <gtest/gtest.h>

#include "modified_case.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;
using tests::solution_of;

std::string script_of(const results::CaseResult& case_result) {
  return density_script(case_result.problem, figure_content(case_result), "stem");
}

TEST(DensityScript, HoldsItsDataAndAnEntryForEveryCurve) {
  const auto case_result = made_up_case();
  const std::string script = script_of(case_result);
  EXPECT_TRUE(script.starts_with("# Drawn by: gnuplot stem.gp"));
  for (const auto& solution : case_result.solutions) {
    const bool drawn = case_result.curve(solution.id(), transform::Variable::y) != nullptr;
    const bool told = contains(script, " title '" + solution.id()) ||
                      contains(script, " title say('" + solution.id());
    EXPECT_EQ(told, drawn) << solution.id();
  }
  EXPECT_TRUE(contains(script, " title 'epc-gaussian-n4 (inadmissible)'"));
  EXPECT_TRUE(contains(script, " title say('mcs, with 95 % intervals'"));
}

TEST(DensityScript, HasALegendEntryForEachStyle) {
  auto smooth = tests::made_up_case_with_control_variates();
  auto marked = made_up_case();
  for (auto* case_result : {&smooth, &marked}) {
    solution_of(*case_result, "epc-gaussian-n2").identity.plot_style.symbol = "square";
    for (const auto width :
         {FigureWidth::screen, FigureWidth::two_columns, FigureWidth::one_column}) {
      const auto script =
          density_script(case_result->problem, figure_content(*case_result), "stem", width);
      EXPECT_GT(tests::plot_elements(script).size(), 20u);
      const auto untold = tests::elements_without_entry(script);
      EXPECT_TRUE(untold.empty()) << untold.front();
    }
  }
}

TEST(DensityScript, InOneColumnHasLogarithmsAndDifferencesOneBelowAnother) {
  const auto case_result = made_up_case();
  const auto script = density_script(case_result.problem, figure_content(case_result), "stem",
                                     FigureWidth::one_column);
  for (const char* title : {"'(a) displacement'", "'(b) difference from mcs'", "'(c) velocity'",
                            "'(d) difference from mcs'"}) {
    EXPECT_TRUE(contains(script, std::string("set title ") + title)) << title;
  }
  EXPECT_FALSE(contains(script, "(e)"));
}

TEST(DensityScript, HasDifferencesWhereThereIsAReference) {
  auto case_result = made_up_case();
  EXPECT_TRUE(contains(script_of(case_result), "difference from mcs"));
  solution_of(case_result, "fd-kf").status = transform::Status::failed;
  solution_of(case_result, "mcs").status = transform::Status::failed;
  case_result.assess();
  EXPECT_FALSE(contains(script_of(case_result), "difference from mcs"));
  EXPECT_FALSE(contains(script_of(case_result), "_difference"));
}

// A summary from an untrusted source: an id is plain text and cannot end its line.
TEST(DensityScript, RunsNoCommandOfAnId) {
  auto case_result = made_up_case();
  const std::string id = "x\nsystem 'touch PWNED'\n#";
  for (auto& curve : case_result.curves) {
    if (curve.solution == "mcs") curve.solution = id;
  }
  solution_of(case_result, "mcs").identity.id = id;
  case_result.assess();
  EXPECT_TRUE(contains(script_of(case_result), "difference from x system ''touch PWNED'' #"));
  EXPECT_FALSE(contains(script_of(case_result), "\nsystem"));
}

}  // namespace
}  // namespace fpkcheck::report
