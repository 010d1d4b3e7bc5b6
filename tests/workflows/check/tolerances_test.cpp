#include "workflows/check/tolerances.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"

namespace fpkcheck::check {
namespace {

TEST(Tolerances, MustBePositiveNumbers) {
  EXPECT_NO_THROW(validate({}));
  for (const double bad : {0.0, -1.0, double(NAN), double(INFINITY)}) {
    EXPECT_THROW(validate({.deterministic = bad}), InputError);
    EXPECT_THROW(validate({.standard_errors = bad}), InputError);
  }
}

TEST(Tolerances, CoefficientAndTailToleranceFollowTheDeterministicOne) {
  const Tolerances wide{.deterministic = 1e-6};
  EXPECT_DOUBLE_EQ(wide.coefficient_tolerance(), 5e-5);
  EXPECT_DOUBLE_EQ(wide.tail_tolerance(), 1e-4);
}

TEST(Tolerances, BonferroniThresholdGrowsWithTheNumber) {
  const Tolerances tolerances;
  EXPECT_NEAR(tolerances.bonferroni_threshold(1), 4, 1e-9);
  EXPECT_NEAR(tolerances.bonferroni_threshold(0), 4, 1e-9);
  // erfc(x / sqrt 2) is 6.33e-5 at 4, and a hundredth of it at 4.99.
  const double x = tolerances.bonferroni_threshold(100);
  EXPECT_NEAR(std::erfc(x / std::sqrt(2.0)) * 100, std::erfc(4 / std::sqrt(2.0)), 1e-9);
  EXPECT_GT(x, 4.8);
  EXPECT_TRUE(std::isfinite(Tolerances{.standard_errors = 40}.bonferroni_threshold(1000)));
}

}  // namespace
}  // namespace fpkcheck::check
