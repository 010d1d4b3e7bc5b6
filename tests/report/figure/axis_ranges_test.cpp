
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "modified_case.hpp"
#include "report/figure/density_content.hpp"
#include "report/figure/figure.hpp"

namespace fpkcheck::report {
namespace {

using transform::StateVariable;

TEST(MarginalAxisRanges, ContainAllDensitiesAboveTheFloor) {
  const auto case_result = tests::made_up_case();
  for (const auto& marginal : density_content_for_picture(case_result).marginals) {
    for (const auto& drawn : marginal.curves) {
      if (!drawn.solution->has_status_ok()) continue;
      for (std::size_t k = 0; k < drawn.curve->density.size(); ++k) {
        if (drawn.curve->density[k] <= kSmallestDrawnDensity) continue;
        EXPECT_GE(drawn.curve->abscissa[k], marginal.ranges.logarithmic_from);
        EXPECT_LE(drawn.curve->abscissa[k], marginal.ranges.logarithmic_to);
      }
    }
  }
}

TEST(MarginalAxisRanges, ContainTheVisibleDensities) {
  const transform::Solution solution;
  const results::DensityCurve curve{
      "toy", StateVariable::ydot, {-2.5, -1.5, -0.5, 0.5, 1.5}, {1e-7, 1e-5, 4, 1, 0}, {}, {}};
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const DrawnDensityCurve drawn{
      &solution, &curve, {curve.abscissa, {0, 0, -0.5, 0.25, nothing}, {}, {}}};
  const auto ranges = density_axis_ranges(std::vector{drawn});
  EXPECT_EQ(ranges.linear_from, -0.5);
  EXPECT_EQ(ranges.linear_to, 0.5);
  EXPECT_EQ(ranges.logarithmic_from, -1.5);
  EXPECT_EQ(ranges.logarithmic_to, 0.5);
  EXPECT_EQ(ranges.largest_density, 4);
  EXPECT_EQ(ranges.linear_top, 4);
  EXPECT_EQ(density_spike_note(ranges), "");
  EXPECT_EQ(ranges.largest_difference, 0.5);
  EXPECT_EQ(ranges.least_difference, 0.5);
}

TEST(MarginalAxisRanges, StartTheLogarithmicAxisBelowTheData) {
  const transform::Solution solution;
  const auto bottom = [&](std::vector<double> density) {
    const results::DensityCurve curve{
        "toy", StateVariable::y, {0.5, 1.5, 2.5}, std::move(density), {}, {}};
    return logarithmic_axis_bottom(
        density_axis_ranges(std::vector{DrawnDensityCurve{&solution, &curve, {}}}));
  };
  // A density between two walls: a single decade suffices.
  EXPECT_DOUBLE_EQ(bottom({0.35, 0.8, 0.5}), 0.1);
  EXPECT_DOUBLE_EQ(bottom({1.3, 1.4, 1.35}), 0.1);
  EXPECT_DOUBLE_EQ(bottom({2e-4, 1, 0.1}), 1e-4);
  // A density that decays, or with an empty bin, is shown down to the floor.
  EXPECT_DOUBLE_EQ(bottom({1e-9, 1, 0.1}), kSmallestDrawnDensity);
  EXPECT_DOUBLE_EQ(bottom({0, 1, 0.1}), kSmallestDrawnDensity);
}

TEST(MarginalAxisRanges, ExcludeNarrowBinsFromTheLinearAxis) {
  const transform::Solution solution;
  // Bins of width 1, the first divided at 1/4.
  const results::DensityCurve curve{
      "toy", StateVariable::y, {0.125, 0.625, 1.5, 2.5}, {5000, 9, 4, 0.1}, {}, {}};
  const DrawnDensityCurve drawn{&solution, &curve, {curve.abscissa, {-70, 0.1, 0.3, 0.2}, {}, {}}};
  const auto ranges = density_axis_ranges(std::vector{drawn});
  EXPECT_EQ(drawn.undivided_bin_flags(), (std::vector{false, true, true, true}));
  EXPECT_EQ(ranges.linear_top, 9);
  EXPECT_EQ(ranges.linear_to, 2.5);  // above 1/500 of 9
  EXPECT_EQ(ranges.largest_density, 5000);
  EXPECT_EQ(ranges.largest_difference, 0.3);
  EXPECT_EQ(density_spike_note(ranges), "spike up to 5e+03");
}

TEST(MarginalAxisRanges, OfADisplacementBeginAtTheWall) {
  const transform::Solution solution;
  const results::DensityCurve curve{"toy", StateVariable::y, {0.5, 1.5}, {1, 1}, {}, {}};
  const auto ranges = density_axis_ranges(std::vector{DrawnDensityCurve{&solution, &curve, {}}});
  EXPECT_EQ(ranges.linear_from, 0);
  EXPECT_EQ(ranges.logarithmic_from, 0);
  EXPECT_EQ(ranges.largest_difference, 0);
}

TEST(LogarithmicAxis, HoldsAllThatHasALogarithmWithRoomAtBothEnds) {
  FigureSeries series{.name = "toy", .colour = "#000000"};
  for (const double value : {1e-3, 10.0, 0.0, -1.0, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()}) {
    series.points.push_back({.x = 0, .y = value});
  }
  const auto axis = logarithmic_axis("toy", {series}, &FigurePoint::y);
  EXPECT_DOUBLE_EQ(std::log10(axis.from), -3.3);
  EXPECT_DOUBLE_EQ(std::log10(axis.to), 1.4);
}

TEST(LogarithmicAxis, OfNothingIsSomeRange) {
  const auto axis = logarithmic_axis("toy", {}, &FigurePoint::y);
  EXPECT_GT(axis.from, 0);
  EXPECT_LT(axis.from, axis.to);
}

}  // namespace
}  // namespace fpkcheck::report
