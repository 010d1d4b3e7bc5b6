#include <gtest/gtest.h>

#include "base/files/file_transaction.hpp"
#include "made_up_sweep.hpp"
#include "report/figure/gnuplot.hpp"
#include "saved_run.hpp"
#include "script_legend.hpp"
#include "temporary_directory.hpp"
#include "workflows/sweep/report/figure/figures.hpp"

namespace fpkcheck::sweep {
namespace {

// Sweeps of every kind of plan, each also with failures and missing points.
std::vector<SweepResults> all_kinds() {
  using tests::kFiveRestitutions;
  using tests::kThreeRates;
  using tests::kTwoLaws;
  const tests::KeyAndValues restitutions{"system.restitution", "0.6:1"},
      rates{"impulse.rate", "log:0.1:10"}, cubics{"system.cubic", "0:1"};
  std::vector<SweepResults> kinds;
  for (const auto& axes : {std::vector{kFiveRestitutions},
                           {kTwoLaws},
                           {kThreeRates, kTwoLaws},
                           {kFiveRestitutions, kThreeRates},
                           {kFiveRestitutions, kThreeRates, kTwoLaws}}) {
    kinds.push_back(tests::made_up_sweep(axes));
  }
  kinds.push_back(
      tests::made_up_sweep(tests::made_up_plan({restitutions}, SweepPlanDesign::sobol, 9)));
  kinds.push_back(
      tests::made_up_sweep(tests::made_up_plan({restitutions, rates}, SweepPlanDesign::sobol, 9)));
  kinds.push_back(tests::made_up_sweep(
      tests::made_up_plan({restitutions, rates, cubics}, SweepPlanDesign::sobol, 9)));
  // A single cell, and a row of cells.
  kinds.push_back(tests::made_up_sweep({{"system.restitution", "0.6"}, {"impulse.rate", "1"}}));
  kinds.push_back(tests::made_up_sweep({kFiveRestitutions, {"impulse.rate", "1"}}));
  for (std::size_t k = kinds.size(); k-- > 0;) {
    auto broken = kinds[k];
    for (auto& point : broken.points) {
      point.methods[tests::made_up_gaussian] = tests::made_up_failure();
      point.methods[tests::made_up_white].l1 = MarginalL1Values{0, 0};
    }
    broken.points.pop_back();
    if (!broken.points.empty()) broken.points[0].reference.clear();
    kinds.push_back(std::move(broken));
  }
  return kinds;
}

TEST(SweepDrawing, GnuplotDrawsEveryKindWithoutWarnings) {
  if (!tests::gnuplot_exists()) GTEST_SKIP() << "gnuplot is not installed";
  const tests::TemporaryDirectory directory;
  std::size_t kind = 0;
  for (const auto& results : all_kinds()) {
    for (const auto& picture : sweep_figures(results)) {
      const auto script = directory.path() / fmt::format("{}-{}.gp", picture.stem, kind);
      base::write_file_atomically(script, picture.script);
      const auto image = directory.path() / "picture.svg";
      const auto outcome = report::run_gnuplot(
          "gnuplot", {"format='svg'", "target=" + report::quote_for_gnuplot(image.string())},
          script);
      EXPECT_EQ(outcome.exit_code, 0) << script << outcome.message << picture.script;
      EXPECT_EQ(outcome.message, "") << script << picture.script;
      EXPECT_GT(std::filesystem::file_size(image), 1000u);
    }
    ++kind;
  }
}

TEST(SweepDrawing, HasLegendEntriesForEveryKind) {
  for (const auto& results : all_kinds()) {
    for (const auto width : {report::FigureWidth::screen, report::FigureWidth::one_column}) {
      for (const auto& picture : sweep_figures(results, width)) {
        EXPECT_FALSE(tests::plot_elements(picture.script).empty()) << picture.stem;
        const auto untold = tests::elements_without_entry(picture.script);
        EXPECT_TRUE(untold.empty()) << picture.stem << untold.front();
      }
    }
  }
}

TEST(SweepDrawing, LeavesNoPicturesOfAnotherPlan) {
  const tests::TemporaryDirectory directory;
  base::write_file_atomically(directory.path() / "sweep-moments.svg", "of another plan");
  base::write_file_atomically(directory.path() / "mine.svg", "not ours");
  const auto results = tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates});
  const auto warnings =
      draw_sweep_figures(directory.path(), sweep_figures(results), {}, "no-such-gnuplot");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(tests::contains(warnings[0], "install gnuplot")) << warnings[0];
  EXPECT_FALSE(exists(directory.path() / "sweep-moments.svg"));
  EXPECT_TRUE(exists(directory.path() / "mine.svg"));
  EXPECT_TRUE(exists(directory.path() / "sweep-map.gp"));
}

}  // namespace
}  // namespace fpkcheck::sweep
