#include "problem/equivalent_linearisation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"

namespace fpkcheck::problem {
namespace {

TEST(EquivalentLinearisation, MeetsItsOwnEquations) {
  for (int n = 1; n <= 4; ++n) {
    const Problem p = tests::paper_case(n);
    const auto [c_eq, k_eq, s1, s2] = equivalent_linearisation(p);
    EXPECT_NEAR(c_eq, 0.1 + 0.02 * 2 / std::numbers::pi * s2 / s1, 1e-14);
    EXPECT_NEAR(k_eq, 1 + 3 * p.system.coefficients().cubic * s1 * s1, 1e-13);
    EXPECT_NEAR(s2 * s2, p.impulses.intensity() / (2 * c_eq), 1e-13);
    EXPECT_NEAR(s1 * std::sqrt(k_eq), s2, 1e-14);
  }
}

TEST(EquivalentLinearisation, GivesTheFiguresOfTheTrialRunsForCase1) {
  const auto linear = equivalent_linearisation(tests::paper_case(1));
  EXPECT_NEAR(linear.displacement_deviation, 0.627757, 5e-7);
  EXPECT_NEAR(linear.velocity_deviation, 0.663829, 5e-7);
}

TEST(EquivalentLinearisation, SlowestDecayIsThatOfTheRootsOfTheCharacteristicPolynomial) {
  EXPECT_NEAR(slowest_decay_rate({.damping = 0.2, .stiffness = 1}), 0.1, 1e-15);
  EXPECT_NEAR(slowest_decay_rate({.damping = 5, .stiffness = 4}), 1.0, 1e-14);  // (s + 1)(s + 4)
  EXPECT_NEAR(slowest_decay_rate({.damping = 1e9, .stiffness = 1}), 1e-9, 1e-20);
}

TEST(EquivalentLinearisation, CountsImpulsesInItsSlowestDecay) {
  const Problem p = tests::make_problem({.damping = 0.2, .cubic = 0, .restitution = 1, .rate = 3});
  EXPECT_NEAR(impulses_per_decay_time(p), 30, 1e-12);  // kappa = c/2
}

TEST(EquivalentLinearisation, StaticDeflectionBalancesTheMeanForce) {
  const Problem p = tests::make_problem({.cubic = 0.5, .rate = 2, .intensity = 1, .mean = 0.6});
  EXPECT_NEAR(p.system.restoring_force()(static_deflection(p)), 1.2, 1e-12);
  // Impulses towards the wall
  EXPECT_EQ(static_deflection(tests::make_problem({.mean = -0.1})), 0.0);
}

TEST(EquivalentLinearisation, IsExactForTheElasticLinearOscillator) {
  const auto linear =
      equivalent_linearisation(tests::make_problem({.stiffness = 4, .cubic = 0, .restitution = 1}));
  EXPECT_NEAR(linear.velocity_deviation, std::sqrt(0.1 / 0.2), 1e-15);
  EXPECT_NEAR(linear.displacement_deviation, std::sqrt(0.5) / 2, 1e-15);
}

}  // namespace
}  // namespace fpkcheck::problem
