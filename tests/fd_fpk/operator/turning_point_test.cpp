#include "fd_fpk/operator/turning_point.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

TEST(TurningPoint, IsWhereAllOfTheEnergyIsPotential) {
  for (const double cubic : {0.0, 0.1, 1e4}) {
    const auto system = tests::make_problem({.cubic = cubic}).system;
    for (const double energy : {1e-20, 0.3, 1e10}) {
      const double y = turning_point(system, energy);
      EXPECT_NEAR(system.potential()(y) / energy, 1, 1e-14) << cubic << " " << energy;
    }
  }
}

TEST(TurningPoint, OfALinearSpringIsThatOfTheHarmonicOscillator) {
  const auto system = tests::make_problem({.stiffness = 4, .cubic = 0}).system;
  EXPECT_NEAR(turning_point(system, 0.5 * 9), 1.5, 1e-15);  // k y^2 = v^2
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
