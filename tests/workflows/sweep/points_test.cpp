#include "workflows/sweep/plan/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

const Axis kRates = axis_from("impulse.rate", "1,2", "x");
const Axis kLosses = axis_from("system.restitution", "0.8,0.9,1", "x");

TEST(Points, OfAProductTheLastAxisVariesFastest) {
  const Points points = points_of({kRates, kLosses}, Design::product, 0);
  ASSERT_EQ(points.size(), 6);
  EXPECT_EQ(points[1], (std::vector<base::Value>{1.0, 0.9}));
  EXPECT_EQ(points[3], (std::vector<base::Value>{2.0, 0.8}));
}

TEST(Points, OfAListAreTheValuesTogether) {
  const Axis two = axis_from("system.restitution", "0.8,0.9", "x");
  EXPECT_EQ(points_of({kRates, two}, Design::list, 0), (Points{{1.0, 0.8}, {2.0, 0.9}}));
  EXPECT_THROW(points_of({kRates, kLosses}, Design::list, 0), InputError);
}

// Each sixteenth of each range gets the same number of points, unlike random points.
TEST(Points, OfASobolSequenceFillTheBoxEvenly) {
  const std::vector<Axis> axes{axis_from("impulse.rate", "log:0.1:10", "x"),
                               axis_from("system.restitution", "0.5:1", "x"),
                               axis_from("system.cubic", "1:2", "x")};
  const Points points = points_of(axes, Design::sobol, 255);
  ASSERT_EQ(points.size(), 255);
  for (std::size_t a = 0; a < axes.size(); ++a) {
    std::array<int, 16> counts{};
    for (const auto& point : points) {
      const double value = std::get<double>(point[a]);
      const double part = a == 0   ? (std::log10(value) + 1) / 2
                          : a == 1 ? (value - 0.5) / 0.5
                                   : value - 1;
      ASSERT_GT(part, 0);
      ASSERT_LT(part, 1);
      ++counts[static_cast<std::size_t>(part * 16 + 1e-9)];
    }
    EXPECT_EQ(std::ranges::max(counts), 16);
    EXPECT_EQ(std::ranges::min(counts), 15);  // without the corner
  }
}

TEST(Points, WhatDoesNotFitIsRefused) {
  EXPECT_THROW(points_of({}, Design::product, 0), InputError);
  EXPECT_THROW(points_of({kRates, kRates}, Design::product, 0), InputError);
  EXPECT_THROW(points_of({kRates}, Design::product, 5), InputError);
  EXPECT_THROW(points_of({kRates}, Design::sobol, 5), InputError);
  EXPECT_THROW(points_of({axis_from("impulse.rate", "1:2", "x")}, Design::product, 0), InputError);
  EXPECT_THROW(points_of({axis_from("impulse.rate", "1:2", "x")}, Design::sobol, 0), InputError);
  EXPECT_THROW(points_of({axis_from("impulse.rate", "1:2:2000", "x"),
                          axis_from("system.cubic", "1:2:2000", "x")},
                         Design::product, 0),
               InputError);
}

TEST(Plan, AProblemHasTheValuesOfItsPointAndTheRestOfTheCase) {
  const Plan plan = tests::small_plan();
  const auto problem = plan.problem_at(4);
  EXPECT_EQ(problem.impulses.arrival_rate(), 2);
  EXPECT_EQ(problem.system.coefficients().restitution, 0.9);
  EXPECT_EQ(problem.system.coefficients().cubic, plan.base.system.coefficients().cubic);
  EXPECT_EQ(problem.name, plan.base.name);
}

}  // namespace
}  // namespace fpkcheck::sweep
