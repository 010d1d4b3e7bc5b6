#include "epc/amplitude/amplitude_phase.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::epc::amplitude {
namespace {

TEST(Circle, MaximumOverPhasesIncludesTheWallAndTheAxis) {
  EXPECT_NEAR(maximum_over_phase([](double rho, double theta) { return rho * theta; }, 2), M_PI,
              1e-12);
  EXPECT_NEAR(
      maximum_over_phase([](double rho, double theta) { return rho * (3 - theta * theta); }, 2), 6,
      1e-12);
}

TEST(Circle, AFallIsFollowedToTheDepthAskedForOrToWhereItEnds) {
  const ExponentDecayRange whole =
      find_exponent_decay_range([](double rho, double) { return -rho * rho; }, 25, 10);
  EXPECT_NEAR(whole.crossing.value(), 5, 0.05);
  EXPECT_EQ(whole.extent, 10);
  // -rho^2 + 0.02 rho^4 has its minimum, -12.5, at rho = 5.
  const ExponentDecayRange turned = find_exponent_decay_range(
      [](double rho, double) { return -rho * rho + 0.02 * std::pow(rho, 4); }, 25, 10);
  EXPECT_FALSE(turned.crossing.has_value());
  EXPECT_NEAR(turned.extent, 5, 0.1);
}

}  // namespace
}  // namespace fpkcheck::epc::amplitude
