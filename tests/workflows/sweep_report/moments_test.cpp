#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "saved_run.hpp"

namespace fpkcheck::sweep {
namespace {

using tests::contains;

std::string moments_of(const SweepResults& results) {
  return moments_script(SweepView(results), curves_layout(results.plan), "sweep-moments");
}

TEST(Moments, OfAllMethodsAreDrawnAndInTheLegend) {
  const std::string script = moments_of(tests::made_up_sweep({tests::kFiveRestitutions}));
  for (int m = 0; m < 4; ++m) {
    EXPECT_TRUE(contains(script, fmt::format("$curve_0_{} using 1:7:4", m))) << script;
    EXPECT_TRUE(contains(script, fmt::format("$curve_0_{} using 1:8:4", m))) << script;
  }
  for (const char* id : {"epc-gaussian-n4", "epc-moment-n4", "fd-white", "fd-kf"}) {
    EXPECT_TRUE(contains(script, fmt::format("title '{}'", id))) << script;
  }
}

TEST(Moments, HaveAxesThatCoverOkSolutions) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  EXPECT_TRUE(contains(moments_of(results), "set yrange [0.394:0.506]"));  // not the 9
  for (auto& point : results.points) {
    for (auto& method : point.methods) method.status = transform::Status::inaccurate;
  }
  EXPECT_TRUE(contains(moments_of(results), "set yrange [-0.116:9.516]")) << moments_of(results);
}

}  // namespace
}  // namespace fpkcheck::sweep
