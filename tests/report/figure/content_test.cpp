#include "report/figure/content.hpp"

#include <gtest/gtest.h>

#include "changed_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;
using transform::Status;
using transform::Variable;

TEST(FigureContent, SubtractsTheReference) {
  auto one = made_up_case();
  EXPECT_EQ(figure_content(one).reference, "mcs");
  solution_of(one, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  EXPECT_EQ(figure_content(one).reference, "fd-kf");
  const auto content = figure_content(one);
  const auto& kf = *one.curve("fd-kf", Variable::ydot);
  for (const auto& drawn : content.sides[1].curves) {
    EXPECT_EQ(drawn.difference.values[70], drawn.curve->density[70] - kf.density[70]);
  }
  solution_of(one, "fd-kf").status = Status::not_converged;
  EXPECT_EQ(figure_content(one).reference, "mcs");
  solution_of(one, "mcs").status = Status::failed;
  EXPECT_EQ(figure_content(one).reference, "");
  EXPECT_TRUE(figure_content(one).sides[0].curves[0].difference.empty());
}

TEST(FigureContent, HasTheSizesOfDifferencesOverSmoothBins) {
  auto one = tests::made_up_case_without_noise();
  const auto content = figure_content(one);
  EXPECT_EQ(content.reference, "mcs");
  EXPECT_TRUE(content.smooth_differences);
  const auto& simulated = *one.smooth_curve("mcs", Variable::y);
  for (const auto& drawn : content.sides[0].curves) {
    const auto& own = *one.smooth_curve(drawn.curve->solution, Variable::y);
    EXPECT_EQ(drawn.difference.abscissa, simulated.abscissa);
    for (const std::size_t k : {0u, 7u, 40u}) {
      EXPECT_EQ(drawn.difference.values[k], drawn.curve->solution == "mcs"
                                                ? (own.upper[k] - own.lower[k]) / 2
                                                : std::abs(own.density[k] - simulated.density[k]));
    }
  }
  // With another reference the differences are over sharp bins.
  solution_of(one, "fd-kf").error = {.y_l1 = 1e-7, .ydot_l1 = 1e-7};
  EXPECT_EQ(figure_content(one).reference, "fd-kf");
  EXPECT_FALSE(figure_content(one).smooth_differences);
  EXPECT_EQ(figure_content(one).sides[0].curves[0].difference.values.size(), 140u);
}

TEST(FigureContent, SubtractsNothingWhereTheReferenceLacksACurve) {
  auto one = made_up_case();
  std::erase_if(one.curves, [](const auto& curve) {
    return curve.solution == "mcs" && curve.variable == Variable::y;
  });
  EXPECT_EQ(figure_content(one).reference, "");
}

TEST(FigureContent, ComparesOnlyCurvesOnTheSameBins) {
  auto one = made_up_case();
  for (auto& curve : one.curves) {
    if (curve.solution == "fd-km4") curve.abscissa[0] += 1e-3;
  }
  const auto content = figure_content(one);
  for (const auto& drawn : content.sides[0].curves) {
    EXPECT_EQ(drawn.difference.empty(), drawn.curve->solution == "fd-km4");
  }
}

TEST(FigureContent, RangesFollowOnlySolutionsThatAreOk) {
  auto one = made_up_case();
  const double before = figure_content(one).sides[0].ranges.largest_density;
  for (auto& curve : one.curves) {
    if (curve.solution == "epc-gaussian-n4") curve.density.assign(curve.density.size(), 50);
  }
  EXPECT_EQ(figure_content(one).sides[0].ranges.largest_density, before);
  for (auto& solution : one.solutions) solution.status = Status::failed;
  EXPECT_EQ(figure_content(one).sides[0].ranges.largest_density, 50);
}

TEST(FigureContent, TheAxisOfDifferencesHoldsWhatIsDrawn) {
  // An inaccurate curve with the largest distance to the reference.
  for (auto one : {made_up_case(), tests::made_up_case_without_noise()}) {
    solution_of(one, "fd-white").status = Status::inaccurate;
    const auto raise = [&](std::vector<results::Curve>& curves) {
      for (auto& curve : curves) {
        if (curve.solution == "fd-white") curve.density[20] += 0.3;
      }
    };
    raise(one.curves);
    raise(one.smooth);
    EXPECT_GT(figure_content(one).sides[0].ranges.largest_difference, 0.2);
    // The range shrinks without this curve.
    const auto without = figure_content(one, std::set<std::string>{"fd-kf", "fd-km4", "mcs"});
    EXPECT_LT(without.sides[0].ranges.largest_difference, 0.2);
  }
}

TEST(FigureContent, DrawsLowerLayersFirst) {
  auto one = made_up_case();
  solution_of(one, "fd-km4").identity.look.layer = 9;
  solution_of(one, "mcs").identity.look.layer = -1;
  const auto content = figure_content(one);
  EXPECT_EQ(content.sides[0].curves.front().curve->solution, "mcs");
  EXPECT_EQ(content.sides[0].curves.back().curve->solution, "fd-km4");
}

TEST(FigureContent, HasNoSideWithoutACurve) {
  auto one = made_up_case();
  std::erase_if(one.curves, [](const auto& curve) { return curve.variable == Variable::y; });
  const auto content = figure_content(one);
  ASSERT_EQ(content.sides.size(), 1u);
  EXPECT_EQ(content.sides[0].variable, Variable::ydot);
}

}  // namespace
}  // namespace fpkcheck::report
