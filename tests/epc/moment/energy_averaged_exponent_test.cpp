#include "epc/moment/energy_averaged_exponent.hpp"

#include <gtest/gtest.h>

#include "general_oscillators.hpp"

namespace fpkcheck::epc::moment {
namespace {

using problem::System;
using tests::with_noise;

// Under white noise Phi = (c/D) h exactly; D = 0.2, c = 0.1.
TEST(EnergyAveragedExponent, IsTheEnergyWhereDampingIsConstant) {
  const auto p =
      with_noise(System({.damping = 0.1, .stiffness = 2, .cubic = 1}, {.none = true}), 0.4);
  const EnergyAveragedExponent exponent(p);
  const auto energy = [](double y, double v) { return v * v / 2 + y * y + y * y * y * y / 4; };
  for (const double y : {-1.0, 0.0, 0.4, 5.0}) {
    for (const double v : {-2.0, 0.1, 9.0}) {
      EXPECT_NEAR(exponent(y, v) - exponent(0.3, 0.2), -(energy(y, v) - energy(0.3, 0.2)) / 2,
                  1e-6 * (1 + energy(y, v)))
          << y << ' ' << v;
    }
  }
  EXPECT_NEAR(exponent.temperature(), 2, 0.01);  // a sum over bands
  EXPECT_NEAR(exponent.energy_at_exponent_decrease(20), 40, 0.5);
  EXPECT_EQ(exponent.barrier_energy(), 0);
  EXPECT_GT(exponent.energy_of_95_percent_quantile(), 4);
  EXPECT_LT(exponent.energy_of_95_percent_quantile(),
            9);  // 95 % of the mass of laws with mean T to 2 T: at least 3 T
}

// The potential has minima at +-1, and a maximum at 0 that is higher by 1/4. Below the maximum each
// well has separate energies.
TEST(EnergyAveragedExponent, HasABranchForEachWell) {
  const auto p =
      with_noise(System({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true}), 0.02);
  const EnergyAveragedExponent exponent(p);
  EXPECT_NEAR(exponent.barrier_energy(), 0.25, 0.03);
  EXPECT_NEAR(exponent(1, 0) - exponent(0, 0), 0.25 * 0.1 / 0.01, 1e-3);
  EXPECT_NEAR(exponent(-1, 0), exponent(1, 0), 1e-9);
  EXPECT_NEAR(exponent(-1, 0.3) - exponent(1, 0), -0.045 * 0.1 / 0.01, 1e-3);
}

// A ring-shaped density: -Phi = (R - R^2/2) / 0.4 has a maximum at R = y^2 + v^2 = 1.
TEST(EnergyAveragedExponent, HasItsMaximumOnTheRing) {
  const auto p = with_noise(
      System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
      0.4);
  const EnergyAveragedExponent exponent(p);
  const auto exact = [](double r2) { return (r2 - r2 * r2 / 2) / 0.4; };
  for (const double y : {0.3, 1.0, 1.6}) {
    EXPECT_NEAR(exponent(y, 0) - exponent(0, 1), exact(y * y) - exact(1), 5e-3) << y;
  }
}

}  // namespace
}  // namespace fpkcheck::epc::moment
