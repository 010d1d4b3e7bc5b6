#include "backward/residual/judged_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/linear_problem.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::backward {
namespace {

TEST(JudgedFunctions, AreTheMomentsAndBinsThatSumToOne) {
  const auto splines = residual_splines(tests::paper_case(1), {.y = 32, .v = 64});
  const auto judged = judged_functions(splines.y, splines.v);
  ASSERT_EQ(judged.moments, 6);
  ASSERT_EQ(judged.all.size(),
            static_cast<std::size_t>(judged.moments + judged.y_bins + judged.v_bins));
  EXPECT_EQ(judged.y_bins, 16 + 5);  // cells and degree
  EXPECT_EQ(judged.v_bins, 32 + 5);
  for (const auto& [y, v] : {std::pair{0.0, 0.0}, {0.013, -0.4}, {1.1, 2.3}, {80.0, -90.0}}) {
    const auto value = [&, y = y, v = v](std::size_t k) {
      return judged.all[k].of_y(y) * judged.all[k].of_v(v);
    };
    EXPECT_DOUBLE_EQ(value(1), y * y);
    EXPECT_DOUBLE_EQ(value(5), std::pow(v, 4));
    double of_y = 0, of_v = 0;
    for (int b = 0; b < judged.y_bins; ++b) of_y += value(static_cast<std::size_t>(6 + b));
    for (int b = 0; b < judged.v_bins; ++b) {
      of_v += value(static_cast<std::size_t>(6 + judged.y_bins + b));
    }
    EXPECT_NEAR(of_y, 1, 1e-14);
    EXPECT_NEAR(of_v, 1, 1e-14);
  }
}

TEST(JudgedFunctions, ArePowersOfThePhysicalCoordinates) {
  const auto splines = residual_splines(tests::paper_case(1), {.y = 32, .v = 64});
  const auto judged = judged_functions(splines.y, splines.v, {.origin = 0.5, .mirrored = true});
  const auto value = [&](std::size_t k, double y, double v) {
    return judged.all[k].of_y(y) * judged.all[k].of_v(v);
  };
  EXPECT_DOUBLE_EQ(value(0, 2, 7), -1.5);
  EXPECT_DOUBLE_EQ(value(2, 2, 7), std::pow(1.5, 4));
  EXPECT_DOUBLE_EQ(value(3, 2, 7), -7);
  EXPECT_DOUBLE_EQ(value(4, 2, 7), 49);
}

TEST(ResidualSplines, AreFineAtTheWallUnlessTheMotionIsElsewhere) {
  const ControlCells cells{.y = 40, .v = 88};
  const auto usual = usual_splines(tests::paper_case(1), cells);
  const auto splines = residual_splines(tests::paper_case(1), cells);
  EXPECT_LT(splines.y.breaks()[1], usual.y.breaks()[1] / 8);
  EXPECT_EQ(splines.y.end(), usual.y.end());
  EXPECT_EQ(splines.v.begin(), usual.v.begin());
  EXPECT_EQ(splines.v.size(), usual.v.size());
  const auto pushed = tests::make_problem({.rate = 300, .mean = 0.9 * std::sqrt(0.1 / 300)});
  ASSERT_GT(problem::static_deflection(pushed),
            4 * problem::equivalent_linearisation(pushed).displacement_deviation);
  EXPECT_EQ(residual_splines(pushed, cells).y.breaks(), usual_splines(pushed, cells).y.breaks());
}

}  // namespace
}  // namespace fpkcheck::backward
