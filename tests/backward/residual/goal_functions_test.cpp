#include "backward/residual/goal_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "backward/control_variates/control_variate_fit.hpp"
#include "exact/linear_problem.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::backward {
namespace {

TEST(GoalFunctions, AreTheMomentsAndBinsThatSumToOne) {
  const auto splines = make_control_splines(tests::paper_case(1), {.y_cells = 32, .v_cells = 64},
                                            SplineCellWidthDistribution::narrower_at_walls);
  const auto goal = make_goal_functions(splines.y_splines, splines.v_splines);
  ASSERT_EQ(goal.moment_count, 6);
  ASSERT_EQ(goal.functions.size(),
            static_cast<std::size_t>(goal.moment_count + goal.y_bin_count + goal.v_bin_count));
  EXPECT_EQ(goal.y_bin_count, 16 + 5);  // number of cells plus degree
  EXPECT_EQ(goal.v_bin_count, 32 + 5);
  for (const auto& [y, v] : {std::pair{0.0, 0.0}, {0.013, -0.4}, {1.1, 2.3}, {80.0, -90.0}}) {
    const auto value = [&, at_y = y, at_v = v](std::size_t k) {
      return goal.functions[k].y_factor(at_y) * goal.functions[k].v_factor(at_v);
    };
    EXPECT_DOUBLE_EQ(value(1), y * y);
    EXPECT_DOUBLE_EQ(value(5), std::pow(v, 4));
    double y_factor = 0, v_factor = 0;
    for (int b = 0; b < goal.y_bin_count; ++b) y_factor += value(static_cast<std::size_t>(6 + b));
    for (int b = 0; b < goal.v_bin_count; ++b) {
      v_factor += value(static_cast<std::size_t>(6 + goal.y_bin_count + b));
    }
    EXPECT_NEAR(y_factor, 1, 1e-14);
    EXPECT_NEAR(v_factor, 1, 1e-14);
  }
}

TEST(GoalFunctions, ArePowersOfThePhysicalCoordinates) {
  const auto splines = make_control_splines(tests::paper_case(1), {.y_cells = 32, .v_cells = 64},
                                            SplineCellWidthDistribution::narrower_at_walls);
  const auto goal =
      make_goal_functions(splines.y_splines, splines.v_splines, {.origin = 0.5, .mirrored = true});
  const auto value = [&](std::size_t k, double y, double v) {
    return goal.functions[k].y_factor(y) * goal.functions[k].v_factor(v);
  };
  EXPECT_DOUBLE_EQ(value(0, 2, 7), -1.5);
  EXPECT_DOUBLE_EQ(value(2, 2, 7), std::pow(1.5, 4));
  EXPECT_DOUBLE_EQ(value(3, 2, 7), -7);
  EXPECT_DOUBLE_EQ(value(4, 2, 7), 49);
}

TEST(ControlSplines, AreNarrowerAtTheWallUnlessTheMotionIsOffTheWall) {
  const ControlVariateCellCounts cells{.y_cells = 40, .v_cells = 88};
  const auto even =
      make_control_splines(tests::paper_case(1), cells, SplineCellWidthDistribution::equal);
  const auto splines = make_control_splines(tests::paper_case(1), cells,
                                            SplineCellWidthDistribution::narrower_at_walls);
  EXPECT_LT(splines.y_splines.breaks()[1], even.y_splines.breaks()[1] / 8);
  EXPECT_EQ(splines.y_splines.end(), even.y_splines.end());
  EXPECT_EQ(splines.v_splines.begin(), even.v_splines.begin());
  EXPECT_EQ(splines.v_splines.size(), even.v_splines.size());
  const auto pushed = tests::make_problem({.rate = 300, .mean = 0.9 * std::sqrt(0.1 / 300)});
  ASSERT_GT(problem::static_deflection(pushed),
            4 * problem::equivalent_linearisation(pushed).displacement_deviation);
  const auto off_wall =
      make_control_splines(pushed, cells, SplineCellWidthDistribution::narrower_at_walls);
  constexpr int kEvenCells = 30;  // of 40, up to five deviations from the deflection
  for (int k = 2; k <= kEvenCells; ++k) {
    EXPECT_NEAR(off_wall.y_splines.breaks()[k], k * off_wall.y_splines.breaks()[1], 1e-12);
  }
}

}  // namespace
}  // namespace fpkcheck::backward
