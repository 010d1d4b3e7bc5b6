#include "workflows/sweep/report/figure/figures.hpp"

#include <gtest/gtest.h>

#include "made_up_sweep.hpp"
#include "problem/case_file.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {
namespace {

std::vector<std::string> stems(const SweepResults& results) {
  std::vector<std::string> found;
  for (const auto& picture : sweep_figures(results)) found.push_back(picture.stem);
  return found;
}

const std::vector<std::string> kCurves{"sweep-distances", "sweep-moments"}, kMap{"sweep-map"},
    kKeys{"sweep-keys"};

TEST(SweepPictures, HaveTitlesWithFormulasAndMissingWalls) {
  auto plan = tests::made_up_plan({tests::kThreeRates});
  plan.base = problem::load_case("hertz");
  EXPECT_EQ(fixed_parameters_text(plan),
            "f = c*v + y - k*max(-y, 0)^1.5, c = 0.1, k = 50, no wall, gaussian impulses, "
            "λ E[Y²] = 0.2");
}

TEST(SweepPictures, AreCurvesOverOneKey) {
  EXPECT_EQ(stems(tests::made_up_sweep({tests::kFiveRestitutions})), kCurves);
  EXPECT_EQ(stems(tests::made_up_sweep({tests::kTwoLaws})), kCurves);
  EXPECT_EQ(stems(tests::made_up_sweep({tests::kThreeRates, tests::kTwoLaws})), kCurves);
}

TEST(SweepPictures, AreMapsOverTwo) {
  EXPECT_EQ(stems(tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates})), kMap);
  EXPECT_EQ(stems(tests::made_up_sweep(tests::made_up_plan(
                {{"system.restitution", "0.6,0.7"}, tests::kTwoLaws}, SweepPlanDesign::list))),
            kMap);
}

TEST(SweepPictures, AreOneOverEachOfMore) {
  EXPECT_EQ(
      stems(tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates, tests::kTwoLaws})),
      kKeys);
}

TEST(SweepPictures, WithoutAReferenceHaveNoDistances) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  for (auto& point : results.points) {
    point.reference.clear();
    for (auto& method : point.methods) method.l1.reset();
  }
  EXPECT_EQ(stems(results), std::vector<std::string>{"sweep-moments"});
}

TEST(SweepPictures, AreEmptyWithoutComparisons) {
  auto results = tests::made_up_sweep({tests::kFiveRestitutions});
  results.points.clear();
  EXPECT_TRUE(sweep_figures(results).empty());

  auto alone = tests::made_up_sweep({tests::kFiveRestitutions, tests::kThreeRates});
  alone.plan.methods = {alone.plan.methods[tests::made_up_reference]};
  for (auto& point : alone.points) point.methods = {point.methods[tests::made_up_reference]};
  EXPECT_TRUE(sweep_figures(alone).empty());
}

}  // namespace
}  // namespace fpkcheck::sweep
