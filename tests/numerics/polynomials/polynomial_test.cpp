#include "numerics/polynomials/polynomial.hpp"

#include <gtest/gtest.h>

namespace fpkcheck::numerics {
namespace {

TEST(RealRoots, AreFoundBetweenThoseOfTheDerivative) {
  // (x + 2) x (x - 1) (x - 1.5) = x^4 - .5 x^3 - 3.5 x^2 + 3 x
  const auto roots = sign_change_points(Polynomial({0, 3, -3.5, -0.5, 1}), -10, 10);
  ASSERT_EQ(roots.size(), 4u);
  const double exact[] = {-2, 0, 1, 1.5};
  for (int n = 0; n < 4; ++n) EXPECT_NEAR(roots[n], exact[n], 1e-14);
}

TEST(RealRoots, OfEvenOrderChangeNoSign) {
  EXPECT_TRUE(sign_change_points(Polynomial({0, 0, 1}), -1, 1).empty());
  EXPECT_EQ(sign_change_points(Polynomial({0, 0, 0, 1}), -1, 1), std::vector<double>{0});
  EXPECT_EQ(sign_change_points(Polynomial({0, 0, 0, 1}), -1, 2).size(), 1u);
  EXPECT_TRUE(sign_change_points(Polynomial({3}), -1, 1).empty());
}

TEST(RealRoots, LieWithinTheBound) {
  EXPECT_GE(root_modulus_bound(Polynomial({-1e6, 0, 1})), 1e3);
  EXPECT_EQ(root_modulus_bound(Polynomial({5})), 0);
}

}  // namespace
}  // namespace fpkcheck::numerics
