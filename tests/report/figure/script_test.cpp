#include "report/figure/script.hpp"

#include <gtest/gtest.h>

#include "changed_case.hpp"
#include "legend_of_script.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::contains;
using tests::made_up_case;
using tests::solution_of;

std::string script_of(const results::Case& one) {
  return figure_script(one.problem, figure_content(one), "stem");
}

TEST(FigureScript, HoldsItsDataAndAnEntryForEveryCurve) {
  const auto one = made_up_case();
  const std::string script = script_of(one);
  EXPECT_TRUE(script.starts_with("# Drawn by: gnuplot stem.gp"));
  for (const auto& solution : one.solutions) {
    const bool drawn = one.curve(solution.id(), transform::Variable::y) != nullptr;
    const bool told = contains(script, " title '" + solution.id()) ||
                      contains(script, " title say('" + solution.id());
    EXPECT_EQ(told, drawn) << solution.id();
  }
  EXPECT_TRUE(contains(script, " title 'epc-gaussian-n4 (inadmissible)'"));
  EXPECT_TRUE(contains(script, " title say('mcs, with 95 % intervals'"));
}

TEST(FigureScript, TellsWhatEveryCurveIs) {
  auto smooth = tests::made_up_case_without_noise();
  auto marked = made_up_case();
  for (auto* one : {&smooth, &marked}) {
    solution_of(*one, "epc-gaussian-n2").identity.look.symbol = "square";
    for (const auto width :
         {FigureWidth::screen, FigureWidth::two_columns, FigureWidth::one_column}) {
      const auto script = figure_script(one->problem, figure_content(*one), "stem", width);
      EXPECT_GT(tests::drawn_by(script).size(), 20u);
      const auto untold = tests::without_entry(script);
      EXPECT_TRUE(untold.empty()) << untold.front();
    }
  }
}

TEST(FigureScript, InOneColumnHasLogarithmsAndDifferencesOneBelowAnother) {
  const auto one = made_up_case();
  const auto script =
      figure_script(one.problem, figure_content(one), "stem", FigureWidth::one_column);
  for (const char* title : {"'(a) displacement'", "'(b) difference from mcs'", "'(c) velocity'",
                            "'(d) difference from mcs'"}) {
    EXPECT_TRUE(contains(script, std::string("set title ") + title)) << title;
  }
  EXPECT_FALSE(contains(script, "(e)"));
}

TEST(FigureScript, HasDifferencesWhereThereIsAReference) {
  auto one = made_up_case();
  EXPECT_TRUE(contains(script_of(one), "difference from mcs"));
  solution_of(one, "fd-kf").status = transform::Status::failed;
  solution_of(one, "mcs").status = transform::Status::failed;
  EXPECT_FALSE(contains(script_of(one), "difference from mcs"));
  EXPECT_FALSE(contains(script_of(one), "_difference"));
}

// A summary from an untrusted source: an id is plain text and cannot end its line.
TEST(FigureScript, AnIdRunsNothing) {
  auto one = made_up_case();
  const std::string id = "x\nsystem 'touch PWNED'\n#";
  for (auto& curve : one.curves) {
    if (curve.solution == "mcs") curve.solution = id;
  }
  solution_of(one, "mcs").identity.id = id;
  EXPECT_TRUE(contains(script_of(one), "difference from x system ''touch PWNED'' #"));
  EXPECT_FALSE(contains(script_of(one), "\nsystem"));
}

}  // namespace
}  // namespace fpkcheck::report
