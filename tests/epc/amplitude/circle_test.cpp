#include "epc/amplitude/circle.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::epc::amplitude {
namespace {

TEST(Circle, LargestAtAnAmplitudeSeesTheWallAndTheAxis) {
  EXPECT_NEAR(largest_at([](double rho, double theta) { return rho * theta; }, 2), M_PI, 1e-12);
  EXPECT_NEAR(largest_at([](double rho, double theta) { return rho * (3 - theta * theta); }, 2), 6,
              1e-12);
}

TEST(Circle, AFallIsFollowedToTheDepthAskedForOrToWhereItEnds) {
  const Fall whole = fall_of([](double rho, double) { return -rho * rho; }, 25, 10);
  EXPECT_NEAR(whole.reached.value(), 5, 0.05);
  EXPECT_EQ(whole.turning, 10);
  // -rho^2 + 0.02 rho^4 has its minimum, -12.5, at rho = 5.
  const Fall turned =
      fall_of([](double rho, double) { return -rho * rho + 0.02 * std::pow(rho, 4); }, 25, 10);
  EXPECT_FALSE(turned.reached.has_value());
  EXPECT_NEAR(turned.turning, 5, 0.1);
}

}  // namespace
}  // namespace fpkcheck::epc::amplitude
