#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

TEST(Scatter, HasAPanelForEachKeyWithAllMethods) {
  const auto results =
      tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates, tests::kTwoLaws});
  const std::string script = scatter_script(SweepView(results), "sweep-keys");
  for (const char* label : {"system.restitution", "impulse.rate", "impulse.law"}) {
    const bool is_named = contains(script, fmt::format("set xlabel '{}", label)) ||
                          contains(script, fmt::format("set xlabel say('{}", label));
    EXPECT_TRUE(is_named) << script;
  }
  for (int key = 0; key < 3; ++key) {
    for (int m = 0; m < 3; ++m) {
      EXPECT_TRUE(contains(script, fmt::format("$points_{}_{} using 1:2:3", key, m)));
      EXPECT_TRUE(contains(script, fmt::format("$median_{}_{} using 1:2", key, m)));
    }
  }
  for (const char* entry : {"epc-moment-n4", "fd-white", "open: not ok", "median of ok"}) {
    EXPECT_TRUE(contains(script, fmt::format("title '{}'", entry))) << entry;
  }
  EXPECT_FALSE(contains(script, "'fd-kf'"));
  // A logarithmic axis of one panel must not affect the next panel.
  EXPECT_TRUE(contains(script, "unset logscale x"));
}

TEST(Scatter, MediansAreOfOkSolutions) {
  auto results = tests::made_up_sweep(
      {{"system.restitution", "0.6,0.7"}, {"impulse.rate", "1,2,3"}, {"system.cubic", "0.1"}});
  for (std::size_t k = 0; k < 3; ++k) {
    const double l1 = std::vector{0.1, 0.5, 0.2}[k];
    results.points[k].methods[tests::made_up_white].l1 = MarginalL1Pair{l1, l1 / 2};
  }
  const auto script = [&] { return scatter_script(SweepView(results), "sweep-keys"); };
  EXPECT_TRUE(contains(script(), "$median_0_2 << EOD\n0.6 0.2\n0.7 0.03\nEOD\n")) << script();
  results.points[1].methods[tests::made_up_white].status = transform::Status::inaccurate;
  results.points[2].methods[tests::made_up_white].status = transform::Status::inaccurate;
  EXPECT_TRUE(contains(script(), "$median_0_2 << EOD\n0.6 0.1\n")) << script();
}

TEST(Scatter, PartsOfARangeHaveMediansOfSeveralPoints) {
  const auto results = tests::made_up_sweep(tests::made_up_plan(
      {{"system.restitution", "0.6:1"}, {"impulse.rate", "log:0.1:10"}, {"system.cubic", "0:1"}},
      PlanDesign::sobol, 40));
  const std::string script = scatter_script(SweepView(results), "sweep-keys");
  const auto rows_of = [&](const std::string& block) {
    const auto begin = script.find(block + " << EOD\n");
    const auto end = script.find("EOD\n", begin + block.size() + 9);
    return std::count(script.begin() + static_cast<std::ptrdiff_t>(begin),
                      script.begin() + static_cast<std::ptrdiff_t>(end), '\n') -
           1;
  };
  EXPECT_EQ(rows_of("$points_0_2"), 40);
  EXPECT_EQ(rows_of("$median_0_2"), 4);
  EXPECT_EQ(rows_of("$median_0_0"), 1);  // one point is ok: no median, a row of NaN
}

}  // namespace
}  // namespace fpkcheck::sweep
