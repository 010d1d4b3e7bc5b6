#include "exact/energy_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::exact {
namespace {

using problem::System;

TEST(EnergyLaw, EqualsTheDensityOfWhiteNoiseOnTheHalfPlane) {
  const auto p = tests::make_problem({.restitution = 1, .mean = 0.05});
  const WhiteNoiseDensity known(p);
  const EnergyLaw law(p);
  for (const double y : {0.0, 0.7, 2.1}) {
    EXPECT_NEAR(law.displacement_marginal(y), known.displacement_marginal(y), 1e-12);
    EXPECT_NEAR(law(y, 0.3), 2 * known(y, 0.3), 1e-12);
  }
  EXPECT_NEAR(law.velocity_marginal(0.4), known.velocity_marginal(0.4), 1e-12);
}

TEST(EnergyLaw, HasTheMeanSquareVelocityOfEquipartition) {
  const System wells({.damping = 0.1, .constant = 0.05, .stiffness = -1, .cubic = 1},
                     {.none = true});
  const System box({.damping = 0.1, .stiffness = -1},
                   {.left = -0.5, .left_restitution = 1, .right = 2, .right_restitution = 1});
  for (const auto& system : {wells, box}) {
    const EnergyLaw law(tests::with_noise(system, 0.06));
    EXPECT_NEAR(law.moment(0, 0), 1, 1e-13);
    EXPECT_NEAR(law.moment(0, 2), 0.03 / 0.1, 1e-12);
    EXPECT_NEAR(law.moment(0, 1), 0, 1e-14);
  }
}

TEST(EnergyLaw, IsARingForRayleighAndVanDerPolDamping) {
  const double q = 0.4;
  const EnergyLaw law(tests::with_noise(
      System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}), q));
  const auto density = [&](double y, double v) {
    const double ring = y * y + v * v;
    return std::exp((ring - ring * ring / 2) / q);
  };
  EXPECT_NEAR(law(0.9, 0.2) / law(0.1, 0.3), density(0.9, 0.2) / density(0.1, 0.3), 1e-12);
  EXPECT_NEAR(law.moment(0, 0), 1, 1e-13);
  EXPECT_NEAR(law.moment(2, 0), law.moment(0, 2), 1e-12);
}

TEST(EnergyLaw, IsTheSameInWallCoordinates) {
  const auto p =
      tests::with_noise(System({.damping = 0.1, .stiffness = 1, .quadratic = 0.3, .cubic = 0.5},
                               {.right = 0.5, .right_restitution = 1}),
                        0.2);
  const auto seen = tests::in_wall_coordinates(p);
  const EnergyLaw here(p), there(seen);
  for (const double y : {-1.0, 0.2, 0.45}) {
    EXPECT_NEAR(here(y, 0.3), there(seen.frame.wall_coordinate(y), -0.3), 1e-12);
  }
  EXPECT_EQ(here(0.51, 0), 0);
}

TEST(EnergyLaw, IsRefusedForOtherProblems) {
  EXPECT_THROW(EnergyLaw(tests::paper_case(1)), InputError);
  EXPECT_THROW(EnergyLaw(tests::with_noise(
                   System({.damping = -1, .van_der_pol = 1, .stiffness = 1}, {.none = true}), 1)),
               InputError);
}

TEST(LinearCumulants, WithoutAWallHoldUnderAnyMeanAndWithNoise) {
  const System system({.damping = 0.2, .stiffness = 4}, {.none = true});
  auto p = tests::with_impulses(system, tests::gaussian_impulses(2, 0.5, 0.3));
  p.noise.intensity = 0.7;
  EXPECT_NEAR(linear_cumulant(p, 1, 0), 2 * 0.3 / 4, 1e-12);  // mean force over stiffness
  EXPECT_NEAR(linear_cumulant(p, 0, 2), (0.5 + 0.7) / 0.4, 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 2, 0), (0.5 + 0.7) / 0.4 / 4, 1e-12);
  auto without = p;
  without.noise.intensity = 0;
  EXPECT_EQ(linear_cumulant(p, 3, 0), linear_cumulant(without, 3, 0));
}

}  // namespace
}  // namespace fpkcheck::exact
