#include "workflows/sweep/plan/points.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/input_error.hpp"
#include "made_up_sweep.hpp"

namespace fpkcheck::sweep {
namespace {

const Axis kRates = parse_axis("impulse.rate", "1,2", "x");
const Axis kLosses = parse_axis("system.restitution", "0.8,0.9,1", "x");

TEST(Points, OfAProductTheLastAxisVariesFastest) {
  const Points points = make_points({kRates, kLosses}, PlanDesign::product, 0);
  ASSERT_EQ(points.size(), 6);
  EXPECT_EQ(points[1], (std::vector<base::Value>{1.0, 0.9}));
  EXPECT_EQ(points[3], (std::vector<base::Value>{2.0, 0.8}));
}

TEST(Points, OfAListHaveTheKthValues) {
  const Axis two = parse_axis("system.restitution", "0.8,0.9", "x");
  EXPECT_EQ(make_points({kRates, two}, PlanDesign::list, 0), (Points{{1.0, 0.8}, {2.0, 0.9}}));
  EXPECT_THROW(make_points({kRates, kLosses}, PlanDesign::list, 0), InputError);
}

// Each sixteenth of each range gets the same number of points, unlike random points.
TEST(Points, OfASobolSequenceFillTheBoxEvenly) {
  const std::vector<Axis> axes{parse_axis("impulse.rate", "log:0.1:10", "x"),
                               parse_axis("system.restitution", "0.5:1", "x"),
                               parse_axis("system.cubic", "1:2", "x")};
  const Points points = make_points(axes, PlanDesign::sobol, 255);
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

TEST(Points, RefusesInconsistentInput) {
  EXPECT_THROW(make_points({}, PlanDesign::product, 0), InputError);
  EXPECT_THROW(make_points({kRates, kRates}, PlanDesign::product, 0), InputError);
  EXPECT_THROW(make_points({kRates}, PlanDesign::product, 5), InputError);
  EXPECT_THROW(make_points({kRates}, PlanDesign::sobol, 5), InputError);
  EXPECT_THROW(make_points({parse_axis("impulse.rate", "1:2", "x")}, PlanDesign::product, 0),
               InputError);
  EXPECT_THROW(make_points({parse_axis("impulse.rate", "1:2", "x")}, PlanDesign::sobol, 0),
               InputError);
  EXPECT_THROW(make_points({parse_axis("impulse.rate", "1:2:2000", "x"),
                            parse_axis("system.cubic", "1:2:2000", "x")},
                           PlanDesign::product, 0),
               InputError);
}

TEST(Plan, AProblemHasTheValuesOfItsPoint) {
  const Plan plan = tests::small_plan();
  const auto problem = plan.problem_at(4);
  EXPECT_EQ(problem.impulses.arrival_rate(), 2);
  EXPECT_EQ(problem.system.coefficients().restitution, 0.9);
  EXPECT_EQ(problem.system.coefficients().cubic, plan.base.system.coefficients().cubic);
  EXPECT_EQ(problem.name, plan.base.name);
}

}  // namespace
}  // namespace fpkcheck::sweep
