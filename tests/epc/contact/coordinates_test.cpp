#include <gtest/gtest.h>

#include <cmath>

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/closure_density.hpp"
#include "general_oscillators.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::epc::contact {
namespace {

using problem::System;

problem::Problem pressed_mass_problem(const problem::SystemCoefficients& coefficients) {
  return tests::with_impulses(System(coefficients), tests::gaussian_impulses(0.8, 0.4));
}

TEST(ContactCoordinates, ApplyWhereOneWallIsPressedOnFromEverywhere) {
  const auto impulses = tests::gaussian_impulses(1, 0.1);
  EXPECT_TRUE(spring_presses_on_single_wall(
      pressed_mass_problem({.constant = 0.5, .stiffness = 1, .restitution = 0.7})));
  EXPECT_FALSE(spring_presses_on_single_wall(
      pressed_mass_problem({.damping = 0.1, .stiffness = 1, .restitution = 0.7})));
  EXPECT_FALSE(spring_presses_on_single_wall(
      pressed_mass_problem({.constant = 0.5, .stiffness = 1, .restitution = 1.0})));
  // At the wall the force presses the mass against the wall, but there is another well.
  EXPECT_FALSE(spring_presses_on_single_wall(tests::in_wall_coordinates(
      tests::with_impulses(System({.damping = 0.1, .stiffness = -1, .cubic = 1},
                                  {.left = -0.5, .left_restitution = 0.7}),
                           impulses))));
  const auto on_the_right =
      tests::with_impulses(System({.damping = 0.1, .constant = -0.5, .stiffness = 1},
                                  {.right = 0, .right_restitution = 0.7}),
                           impulses);
  EXPECT_TRUE(spring_presses_on_single_wall(on_the_right));
  EXPECT_TRUE(spring_presses_on_single_wall(tests::in_wall_coordinates(on_the_right)));
  auto noisy = pressed_mass_problem({.constant = 0.5, .stiffness = 1, .restitution = 0.7});
  noisy.noise.intensity = 0.1;
  EXPECT_FALSE(spring_presses_on_single_wall(noisy));
}

TEST(ContactCoordinates, AreInverseToEachOtherAndOfTheEnergy) {
  for (const double cubic : {0.0, 0.7}) {
    const auto p =
        pressed_mass_problem({.constant = 0.5, .stiffness = 1, .cubic = cubic, .restitution = 0.7});
    const AmplitudeVelocityCoordinates coordinates(p);
    for (const double y : {0.0, 1e-12, 1e-3, 0.3, 5.0}) {
      EXPECT_NEAR(coordinates.displacement(coordinates.sqrt_twice_potential(y)), y, 4e-14 * y);
      const double energy = 0.32 + 0.5 * y + y * y / 2 + cubic * std::pow(y, 4) / 4;
      EXPECT_NEAR(std::pow(coordinates.amplitude_of(y, -0.8), 2) / 2, energy, 1e-14 * energy);
    }
  }
}

// For a constant force g, rho^2 = v^2 + 2 g y. The area below an energy h is
// (2/3) (2 h)^(3/2) / g.
TEST(ContactRule, HasTheAreaBelowAnEnergyAndTheAtom) {
  const double g = 1.7, r = 0.6, rho_max = 2;
  const auto p = pressed_mass_problem({.constant = g, .stiffness = 0, .restitution = r});
  const AmplitudeVelocityCoordinates coordinates(p);
  const auto points = amplitude::quadrature_points(coordinates, rho_max, {}, {24, 24, 24});
  double area = 0, first_moment = 0;
  for (Eigen::Index i = 0; i + 1 < points.size(); ++i) {
    const double y = points.y[i], v = points.v[i], rho = points.s[i];
    EXPECT_EQ(points.t[i], v);
    EXPECT_NEAR(rho * rho, v * v + 2 * g * y, 1e-13);
    EXPECT_NEAR(points.energy[i], v * v / 2 + g * y, 1e-13);
    area += points.weight[i] * rho * rho / 2;
    first_moment += points.weight[i] * rho * rho / 2 * y;
  }
  EXPECT_NEAR(area, 2.0 / 3 * std::pow(rho_max, 3) / g, 1e-12);
  // The expected value is the integral over v of (rho_max^2 - v^2)^2 / (8 g^2).
  EXPECT_NEAR(first_moment, 16.0 / 15 * std::pow(rho_max, 5) / (8 * g * g), 1e-12);
  const Eigen::Index last = points.size() - 1;
  for (const auto* column : {&points.s, &points.t, &points.y, &points.v, &points.energy}) {
    EXPECT_EQ((*column)[last], 0);
  }
  EXPECT_NEAR(points.weight[last], 2 * std::log(1 / r) / 0.8, 1e-15);
}

// The integral of exp(-e/T) / e beyond an energy h, with dA/de = 2 sqrt(2 e) / g, is about
// T exp(-h/T) 2 sqrt(2 h) / (g h).
TEST(ContactContour, HasTheDensityBeyondAnEnergy) {
  const double g = 1.7, rho = 3, temperature = 0.3;
  const auto p = pressed_mass_problem({.constant = g, .stiffness = 0, .restitution = 0.6});
  const ExponentPolynomial q({{2, 0, -1 / (2 * temperature)}});
  const double h = rho * rho / 2;
  const double expected = temperature * std::exp(-h / temperature) * 2 * rho / (g * h);
  EXPECT_NEAR(half_plane::probability_beyond_contour(
                  q, amplitude::constant_amplitude_contour(AmplitudeVelocityCoordinates(p), rho),
                  temperature, 0),
              expected, 2e-3 * expected);
}

TEST(ContactContour, LeadingFormIsTheSignOfTheHighestPowersAlongEveryPhase) {
  // -rho^2 + 0.5 v^2 falls at every phase, -rho^2 + 1.2 v^2 rises at the wall.
  EXPECT_TRUE(amplitude::leading_form_of_amplitude_exponent<AmplitudeVelocityCoordinates>(
                  ExponentPolynomial({{2, 0, -1}, {0, 2, 0.5}}), {1, 1})
                  .negative);
  const ExponentBehaviourAtInfinity rising =
      amplitude::leading_form_of_amplitude_exponent<AmplitudeVelocityCoordinates>(
          ExponentPolynomial({{2, 0, -1}, {0, 2, 1.2}}), {1, 1});
  EXPECT_FALSE(rising.negative);
  EXPECT_NEAR(std::abs(rising.worst.x2), 1, 1e-15);
  EXPECT_GT(rising.rising_fraction, 0);
  EXPECT_LT(rising.rising_fraction, 0.5);
  const ExponentBehaviourAtInfinity turning =
      amplitude::leading_form_of_amplitude_exponent<AmplitudeVelocityCoordinates>(
          ExponentPolynomial({{2, 0, -1}, {4, 0, 0.02}}), {1, 2});
  EXPECT_NEAR(turning.rises_from, 2.5, 0.06);  // in deviations of v
}

}  // namespace
}  // namespace fpkcheck::epc::contact
