#include "workflows/sweep/result/dimensionless_groups.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"

namespace fpkcheck::sweep {
namespace {

// Units of length and time reduced to a third and a half: c and lambda become 2 times as large, k 4
// times, mu 4 * 9 times, and lambda E[Y^2], a squared velocity per time, 2 * 4 / 9 times.
TEST(DimensionlessGroups, DoNotDependOnUnits) {
  const auto one = dimensionless_groups(tests::make_problem({}));
  const auto other = dimensionless_groups(tests::make_problem(
      {.damping = 0.2, .stiffness = 4, .cubic = 0.1 * 36, .rate = 2, .intensity = 0.1 * 8 / 9}));
  EXPECT_NEAR(one.impulses_per_decay_time, other.impulses_per_decay_time, 1e-9);
  EXPECT_NEAR(one.damping_ratio, other.damping_ratio, 1e-12);
  EXPECT_NEAR(one.cubic_share, other.cubic_share, 1e-12);
}

TEST(DimensionlessGroups, OfALinearSpringAndOfAPurelyCubicOne) {
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.cubic = 0})).cubic_share, 0, 1e-12);
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.stiffness = 0})).cubic_share, 1, 1e-12);
  EXPECT_NEAR(dimensionless_groups(tests::make_problem({.cubic = 0})).damping_ratio, 0.05, 1e-12);
}

}  // namespace
}  // namespace fpkcheck::sweep
