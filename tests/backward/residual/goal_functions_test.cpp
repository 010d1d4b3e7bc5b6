#include "backward/residual/goal_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "backward/control/control_function_fit.hpp"
#include "exact/linear_problem.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::backward {
namespace {

TEST(GoalFunctions, AreTheMomentsAndBinsThatSumToOne) {
  const auto splines =
      control_splines(tests::paper_case(1), {.y = 32, .v = 64}, CellWidths::narrower_at_walls);
  const auto goal = goal_functions(splines.y, splines.v);
  ASSERT_EQ(goal.moments, 6);
  ASSERT_EQ(goal.all.size(), static_cast<std::size_t>(goal.moments + goal.y_bins + goal.v_bins));
  EXPECT_EQ(goal.y_bins, 16 + 5);  // number of cells plus degree
  EXPECT_EQ(goal.v_bins, 32 + 5);
  for (const auto& [y, v] : {std::pair{0.0, 0.0}, {0.013, -0.4}, {1.1, 2.3}, {80.0, -90.0}}) {
    const auto value = [&, at_y = y, at_v = v](std::size_t k) {
      return goal.all[k].y_factor(at_y) * goal.all[k].v_factor(at_v);
    };
    EXPECT_DOUBLE_EQ(value(1), y * y);
    EXPECT_DOUBLE_EQ(value(5), std::pow(v, 4));
    double y_factor = 0, v_factor = 0;
    for (int b = 0; b < goal.y_bins; ++b) y_factor += value(static_cast<std::size_t>(6 + b));
    for (int b = 0; b < goal.v_bins; ++b) {
      v_factor += value(static_cast<std::size_t>(6 + goal.y_bins + b));
    }
    EXPECT_NEAR(y_factor, 1, 1e-14);
    EXPECT_NEAR(v_factor, 1, 1e-14);
  }
}

TEST(GoalFunctions, ArePowersOfThePhysicalCoordinates) {
  const auto splines =
      control_splines(tests::paper_case(1), {.y = 32, .v = 64}, CellWidths::narrower_at_walls);
  const auto goal = goal_functions(splines.y, splines.v, {.origin = 0.5, .mirrored = true});
  const auto value = [&](std::size_t k, double y, double v) {
    return goal.all[k].y_factor(y) * goal.all[k].v_factor(v);
  };
  EXPECT_DOUBLE_EQ(value(0, 2, 7), -1.5);
  EXPECT_DOUBLE_EQ(value(2, 2, 7), std::pow(1.5, 4));
  EXPECT_DOUBLE_EQ(value(3, 2, 7), -7);
  EXPECT_DOUBLE_EQ(value(4, 2, 7), 49);
}

TEST(ControlSplines, AreNarrowerAtTheWallUnlessTheMotionIsOffTheWall) {
  const ControlCells cells{.y = 40, .v = 88};
  const auto even = control_splines(tests::paper_case(1), cells, CellWidths::even);
  const auto splines = control_splines(tests::paper_case(1), cells, CellWidths::narrower_at_walls);
  EXPECT_LT(splines.y.breaks()[1], even.y.breaks()[1] / 8);
  EXPECT_EQ(splines.y.end(), even.y.end());
  EXPECT_EQ(splines.v.begin(), even.v.begin());
  EXPECT_EQ(splines.v.size(), even.v.size());
  const auto pushed = tests::make_problem({.rate = 300, .mean = 0.9 * std::sqrt(0.1 / 300)});
  ASSERT_GT(problem::static_deflection(pushed),
            4 * problem::equivalent_linearisation(pushed).displacement_deviation);
  const auto off_wall = control_splines(pushed, cells, CellWidths::narrower_at_walls);
  constexpr int kEvenCells = 30;  // of 40, up to five deviations from the deflection
  for (int k = 2; k <= kEvenCells; ++k) {
    EXPECT_NEAR(off_wall.y.breaks()[k], k * off_wall.y.breaks()[1], 1e-12);
  }
}

}  // namespace
}  // namespace fpkcheck::backward
