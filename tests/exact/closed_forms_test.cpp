#include "exact/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "paper_cases.hpp"
#include "problem/balances.hpp"
#include "problem/equivalent_linearisation.hpp"
#include "trapezoid.hpp"

namespace fpkcheck::exact {

using namespace problem;

namespace {

TEST(Exact, WhiteNoiseDensityIsNormalisedAndSolvesTheEquation) {
  const Problem p = tests::make_problem({.cubic = 0.5, .restitution = 1});
  const WhiteNoiseDensity density(p);
  EXPECT_NEAR(
      tests::trapezoid([&](double x) { return density.displacement_marginal(std::abs(x)) / 2; }, -6,
                       6, 600),
      1.0, 1e-12);
  // -x2 p_1 + d/dx2[(c x2 + k x1 + mu x1^3) p] + D2 p_22 = 0, by central differences.
  const double h = 1e-3, d2 = p.impulses.intensity() / 2, x1 = 0.6, x2 = -0.4;
  const auto drift = [&](double u) {
    return (p.system.damping() * u + p.system.restoring_force()(x1)) * density(x1, u);
  };
  const double residual =
      -x2 * (density(x1 + h, x2) - density(x1 - h, x2)) / (2 * h) +
      (drift(x2 + h) - drift(x2 - h)) / (2 * h) +
      d2 * (density(x1, x2 + h) - 2 * density(x1, x2) + density(x1, x2 - h)) / (h * h);
  EXPECT_NEAR(residual, 0.0, 1e-6);
}

TEST(Exact, WhiteNoiseDensityMeetsTheEnergyBalance) {
  const Problem p = tests::make_problem({.restitution = 1});
  const WhiteNoiseDensity density(p);
  const double v2 =
      tests::trapezoid([&](double v) { return v * v * density.velocity_marginal(v); }, -9, 9, 400);
  EXPECT_NEAR(v2, mean_square_velocity(p), 1e-12);
  EXPECT_NEAR(power_balance_residual(p, {.mean_velocity = 0,
                                         .mean_square_velocity = v2,
                                         .left_impact_loss = impact_energy_loss_rate(
                                             p.system.left_wall(), ImpactCondition::map, 3)}),
              0.0, 1e-12);
}

TEST(Exact, EnergyResidualUsesTheImpactCondition) {
  const Problem p = tests::make_problem({.restitution = 0.8});
  const auto residual = [&](ImpactCondition impact) {
    return power_balance_residual(
        p, {.mean_velocity = 0,
            .mean_square_velocity = 0.3,
            .left_impact_loss = impact_energy_loss_rate(p.system.left_wall(), impact, 0.05)});
  };
  // input 0.05; map: 0.03 + 0.18 * 0.05; delta: 0.03 + 0.2 * 0.05
  EXPECT_NEAR(residual(ImpactCondition::map), (0.05 - 0.039) / 0.05, 1e-14);
  EXPECT_NEAR(residual(ImpactCondition::exact), (0.05 - 0.039) / 0.05, 1e-14);
  EXPECT_NEAR(residual(ImpactCondition::delta), (0.05 - 0.040) / 0.05, 1e-14);
}

TEST(Exact, LinearCumulantsAgreeWithKnownFourthMoments) {
  const Problem p = tests::make_problem({.cubic = 0, .restitution = 1});
  const double x2 = linear_cumulant(p, 2, 0), v2 = linear_cumulant(p, 0, 2);
  EXPECT_NEAR(x2, 0.5, 1e-12);  // lambda E[Y^2] / (2 c k)
  EXPECT_NEAR(v2, 0.5, 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 1, 1), 0.0, 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 4, 0) + 3 * x2 * x2, 0.8058313, 5e-8);
  // The theory notes have 0.8063895; the integral of h'^4 by hand ends in ...896.
  EXPECT_NEAR(linear_cumulant(p, 0, 4) + 3 * v2 * v2, 0.8063896, 5e-8);
}

// Without a wall, the cumulants of a skew law contain its odd moments.
TEST(Exact, LinearCumulantsOfASkewLawHaveItsOddMoments) {
  const auto solved = [](double skewness) {
    return Problem{"linear", System({.damping = 0.1, .stiffness = 1}, {.none = true}),
                   ImpulseTrain({.arrival_rate = 1,
                                 .law = "exponential",
                                 .intensity = 0.1,
                                 .mean = 0,
                                 .skewness = skewness})};
  };
  const Problem p = solved(2), mirrored = solved(-2);
  const double deviation = std::sqrt(0.1);
  // int_0^inf exp(-3 c t/2) sin^3(w t)/w^3 dt
  const double c = 0.1, w2 = 1 - c * c / 4, half = 1.5 * c;
  const double h3 = 6 / ((half * half + w2) * (half * half + 9 * w2));
  EXPECT_NEAR(linear_cumulant(p, 3, 0), 2 * std::pow(deviation, 3) * h3, 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 4, 0) / linear_cumulant(mirrored, 4, 0), 1, 1e-14);
  for (int q = 0; q <= 3; ++q) {
    EXPECT_NEAR(linear_cumulant(mirrored, 3 - q, q), -linear_cumulant(p, 3 - q, q), 1e-14);
  }
}

TEST(Exact, LinearCumulantsHoldUpToCriticalDamping) {
  const Problem p = tests::make_problem({.damping = 1.9999, .cubic = 0, .restitution = 1});
  EXPECT_NEAR(linear_cumulant(p, 2, 0), 0.1 / (2 * 1.9999), 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 0, 2), 0.1 / (2 * 1.9999), 1e-12);
}

// Reference: kappa_n of y by partial fractions, with h = (e^-bt - e^-at) / (a - b).
TEST(Exact, LinearCumulantsHoldBeyondCriticalDamping) {
  const Problem p = tests::make_problem({.damping = 2.5, .cubic = 0, .restitution = 1, .rate = 3});
  const double a = 2, b = 0.5, square = 1 / (2 * a) + 1 / (2 * b) - 2 / (a + b);
  EXPECT_NEAR(linear_cumulant(p, 2, 0), 0.1 * square / std::pow(a - b, 2), 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 2, 0), 0.1 / (2 * 2.5), 1e-12);
  EXPECT_NEAR(linear_cumulant(p, 0, 2), 0.1 / (2 * 2.5), 1e-12);
  const double fourth =
      1 / (4 * b) - 4 / (3 * b + a) + 6 / (2 * a + 2 * b) - 4 / (3 * a + b) + 1 / (4 * a);
  EXPECT_NEAR(linear_cumulant(p, 4, 0),
              p.impulses.rate_times_moment(4) * fourth / std::pow(a - b, 4), 1e-12);
  // On both sides of c^2 = 4k, and at it: int (t e^-t)^4 dt = 4!/4^5.
  const auto near = [](double damping) {
    return linear_cumulant(
        tests::make_problem({.damping = damping, .cubic = 0, .restitution = 1, .rate = 3}), 4, 0);
  };
  EXPECT_NEAR(near(2), p.impulses.rate_times_moment(4) * 24 / 1024, 1e-12);
  EXPECT_NEAR(near(2 - 1e-6) + near(2 + 1e-6), 2 * near(2), 1e-10);
}

TEST(Exact, WhiteNoiseWithAMeanShiftsTheDensityByTheStaticDeflection) {
  const Problem p = tests::make_problem({.cubic = 0, .restitution = 1, .mean = 0.1});
  const WhiteNoiseDensity density(p);
  // A normal density with mean lambda E[Y] / k and variance D2/(c k) = 0.5, truncated at the wall.
  EXPECT_NEAR(density.displacement_marginal(0.3) / density.displacement_marginal(1.2),
              std::exp((1.1 * 1.1 - 0.2 * 0.2) / (2 * 0.5)), 1e-10);
  EXPECT_NEAR(static_deflection(p), 0.1, 1e-14);
}

TEST(Exact, RefusesProblemsWithoutAnExactSolution) {
  EXPECT_THROW(WhiteNoiseDensity{tests::make_problem()}, InputError);
  EXPECT_THROW(linear_cumulant(tests::make_problem({.restitution = 1}), 2, 0), InputError);
  // With a wall, y is not |z| under a skew law.
  EXPECT_THROW(linear_cumulant(
                   tests::make_problem({.cubic = 0, .restitution = 1, .law = "exponential"}), 2, 0),
               InputError);
}

}  // namespace
}  // namespace fpkcheck::exact
