#include "exact/wall_exponent.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::exact {
namespace {

constexpr double kRounding = 1e-14;

TEST(WallExponent, IsZeroForOneAndOneForOneHalf) {
  EXPECT_NEAR(wall_exponent(1), 0, kRounding);
  EXPECT_NEAR(wall_exponent(0.5), 1, kRounding);  // 1/r = 2 sin(pi/2)
}

TEST(WallExponent, IsTheRootThatIsNotTwo) {
  double before = 0;
  for (const double r : {0.98, 0.9, 0.8, 0.6, 0.3, 0.17}) {
    const double beta = wall_exponent(r);
    EXPECT_NEAR(std::pow(r, beta - 2), 2 * std::sin((2 * beta + 1) * std::numbers::pi / 6), 1e-12);
    EXPECT_GT(beta, before) << r;
    EXPECT_LT(beta, 2) << r;
    before = beta;
  }
}

// Reference values from an independent program.
TEST(WallExponent, AgreesWithIndependentValues) {
  EXPECT_NEAR(wall_exponent(0.98), 0.022627, 5e-7);
  EXPECT_NEAR(wall_exponent(0.9), 0.125499, 5e-7);
  EXPECT_NEAR(wall_exponent(0.8), 0.28565, 5e-6);
  EXPECT_NEAR(wall_exponent(0.6), 0.725253, 5e-7);
  EXPECT_NEAR(wall_exponent(0.3), 1.600853, 5e-7);
}

TEST(WallExponent, EndsAtTwoWhereImpactsAccumulate) {
  EXPECT_NEAR(problem::kCollapseRestitution, std::exp(-std::numbers::pi / std::numbers::sqrt3),
              kRounding);
  // Two roots meet: beta = 2 - O(r - r_c).
  EXPECT_NEAR(wall_exponent(problem::kCollapseRestitution * (1 + 1e-6)), 2, 1e-5);
  EXPECT_THROW(wall_exponent(problem::kCollapseRestitution), InputError);
  EXPECT_THROW(wall_exponent(1.1), InputError);
  EXPECT_THROW(wall_exponent(NAN), InputError);
}

}  // namespace
}  // namespace fpkcheck::exact
