#include "report/figure/density_content.hpp"

#include <gtest/gtest.h>

#include "modified_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;
using transform::StateVariable;
using transform::Status;

TEST(DensityFigureContent, SubtractsTheReference) {
  auto case_result = made_up_case();
  EXPECT_EQ(density_content_for_picture(case_result).reference, "mcs");
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  case_result.update_assessment();
  EXPECT_EQ(density_content_for_picture(case_result).reference, "fd-kf");
  const auto content = density_content_for_picture(case_result);
  const auto& kf = *case_result.marginal_curve("fd-kf", StateVariable::ydot);
  for (const auto& drawn : content.marginals[1].curves) {
    EXPECT_EQ(drawn.difference.values[70], drawn.curve->density[70] - kf.density[70]);
  }
  solution_of(case_result, "fd-kf").status = Status::not_converged;
  case_result.update_assessment();
  EXPECT_EQ(density_content_for_picture(case_result).reference, "mcs");
  solution_of(case_result, "mcs").status = Status::failed;
  case_result.update_assessment();
  EXPECT_EQ(density_content_for_picture(case_result).reference, "");
  EXPECT_TRUE(density_content_for_picture(case_result).marginals[0].curves[0].difference.empty());
}

TEST(DensityFigureContent, HasAbsoluteDifferencesOverSmoothBins) {
  auto case_result = tests::made_up_case_with_control_variates();
  const auto content = density_content_for_picture(case_result);
  EXPECT_EQ(content.reference, "mcs");
  EXPECT_TRUE(content.smooth_differences);
  const auto& simulated = *case_result.smooth_curve("mcs", StateVariable::y);
  for (const auto& drawn : content.marginals[0].curves) {
    const auto& own = *case_result.smooth_curve(drawn.curve->solution, StateVariable::y);
    EXPECT_EQ(drawn.difference.abscissa, simulated.abscissa);
    for (const std::size_t k : {0u, 7u, 40u}) {
      EXPECT_EQ(drawn.difference.values[k], drawn.curve->solution == "mcs"
                                                ? (own.upper[k] - own.lower[k]) / 2
                                                : std::abs(own.density[k] - simulated.density[k]));
    }
  }
  // With another reference the differences are over sharp bins.
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-7, .ydot_l1 = 1e-7};
  case_result.update_assessment();
  EXPECT_EQ(density_content_for_picture(case_result).reference, "fd-kf");
  EXPECT_FALSE(density_content_for_picture(case_result).smooth_differences);
  EXPECT_EQ(
      density_content_for_picture(case_result).marginals[0].curves[0].difference.values.size(),
      140u);
}

TEST(DensityFigureContent, SubtractsNothingWhereTheReferenceLacksACurve) {
  auto case_result = made_up_case();
  std::erase_if(case_result.curves, [](const auto& curve) {
    return curve.solution == "mcs" && curve.variable == StateVariable::y;
  });
  EXPECT_EQ(density_content_for_picture(case_result).reference, "");
}

TEST(DensityFigureContent, ComparesOnlyCurvesOnTheSameBins) {
  auto case_result = made_up_case();
  for (auto& curve : case_result.curves) {
    if (curve.solution == "fd-km4") curve.abscissa[0] += 1e-3;
  }
  const auto content = density_content_for_picture(case_result);
  for (const auto& drawn : content.marginals[0].curves) {
    EXPECT_EQ(drawn.difference.empty(), drawn.curve->solution == "fd-km4");
  }
}

TEST(DensityFigureContent, RangesFollowOnlySolutionsThatAreOk) {
  auto case_result = made_up_case();
  const double before =
      density_content_for_picture(case_result).marginals[0].ranges.largest_density;
  for (auto& curve : case_result.curves) {
    if (curve.solution == "epc-gaussian-n4") curve.density.assign(curve.density.size(), 50);
  }
  EXPECT_EQ(density_content_for_picture(case_result).marginals[0].ranges.largest_density, before);
  for (auto& solution : case_result.solutions) solution.status = Status::failed;
  EXPECT_EQ(density_content_for_picture(case_result).marginals[0].ranges.largest_density, 50);
}

TEST(DensityFigureContent, AxisOfDifferencesContainsAllDrawnCurves) {
  // An inaccurate curve with the largest distance to the reference.
  for (auto case_result : {made_up_case(), tests::made_up_case_with_control_variates()}) {
    solution_of(case_result, "fd-white").status = Status::inaccurate;
    case_result.update_assessment();
    const auto raise = [&](std::vector<results::DensityCurve>& curves) {
      for (auto& curve : curves) {
        if (curve.solution == "fd-white") curve.density[20] += 0.3;
      }
    };
    raise(case_result.curves);
    raise(case_result.smooth);
    EXPECT_GT(density_content_for_picture(case_result).marginals[0].ranges.largest_difference, 0.2);
    // The range shrinks without this curve.
    const auto without =
        density_content_for_picture(case_result, std::set<std::string>{"fd-kf", "fd-km4", "mcs"});
    EXPECT_LT(without.marginals[0].ranges.largest_difference, 0.2);
  }
}

TEST(DensityFigureContent, DrawsLowerLayersFirst) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-km4").identity.plot_style.layer = 9;
  solution_of(case_result, "mcs").identity.plot_style.layer = -1;
  const auto content = density_content_for_picture(case_result);
  EXPECT_EQ(content.marginals[0].curves.front().curve->solution, "mcs");
  EXPECT_EQ(content.marginals[0].curves.back().curve->solution, "fd-km4");
}

TEST(DensityFigureContent, HasNoMarginalWithoutACurve) {
  auto case_result = made_up_case();
  std::erase_if(case_result.curves,
                [](const auto& curve) { return curve.variable == StateVariable::y; });
  const auto content = density_content_for_picture(case_result);
  ASSERT_EQ(content.marginals.size(), 1u);
  EXPECT_EQ(content.marginals[0].variable, StateVariable::ydot);
}

}  // namespace
}  // namespace fpkcheck::report
