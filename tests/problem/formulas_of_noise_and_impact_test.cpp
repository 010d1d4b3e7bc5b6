#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "problem/balances.hpp"
#include "problem/case_file.hpp"
#include "problem/energy_averaging.hpp"
#include "problem/problem_features.hpp"
#include "problem/undamped_orbits.hpp"
#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

Problem case_of_formulas(const std::string& text) {
  std::istringstream ini(text);
  return read_case(ini, "a", "a.ini", {}, CaseNamingRule::with_overrides);
}
std::string refusal_of_formulas(const std::string& text) {
  return tests::refusal([&] { case_of_formulas(text); });
}
void expect_refusal(const std::string& text, const std::string& part) {
  EXPECT_NE(refusal_of_formulas(text).find(part), std::string::npos) << refusal_of_formulas(text);
}

const std::string kEnergyDamping =
    "[system]\nforce = 0.1*v + 0.05*v*(y^2+v^2) + y\n[wall]\nnone = true\n"
    "[noise]\nintensity = 0.2\n";
const std::string kFactor = "factor = sqrt(1+0.25*(y^2+v^2))\ninterpretation = ";
const std::string kLinearSpring = "[system]\ndamping = 0.1\nstiffness = 1\n";
const std::string kUnitImpulses = "[impulse]\nrate = 1\nlaw = gaussian\nintensity = 0.2\n";

TEST(NoiseFactor, ChangesTheForceInStratonovichSense) {
  const Problem ito = case_of_formulas(kEnergyDamping + kFactor + "ito"),
                stratonovich = case_of_formulas(kEnergyDamping + kFactor + "stratonovich");
  // D G_v / 2 = 0.1 * 0.5 v / 2
  for (const double v : {-0.7, 0.3}) {
    EXPECT_NEAR(ito.system.force(0.4, v), 0.4 + v * (0.1 + 0.05 * (0.16 + v * v)), 1e-15);
    EXPECT_NEAR(stratonovich.system.force(0.4, v), ito.system.force(0.4, v) - 0.025 * v, 1e-15);
  }
  EXPECT_NEAR(noise_diffusion_coefficient(ito, 0.4, 0.2), 0.1 * (1 + 0.25 * 0.2), 1e-15);
}

// Without a factor of v both senses are one equation, and coefficients remain coefficients.
TEST(NoiseFactor, OfTheDisplacementChangesNoForce) {
  const Problem p =
      case_of_formulas(kLinearSpring + "[wall]\nnone = true\n[noise]\nintensity = 0.2\n" +
                       "factor = sqrt(1+y^2)\ninterpretation = stratonovich\n");
  EXPECT_TRUE(p.system.has_polynomial_force());
  EXPECT_NEAR(p.noise_factor->squared_noise_factor(2, 1), 5, 1e-15);
  EXPECT_FALSE(polynomial_method_unsupported_reason(p).empty());
}

TEST(KinksOfFormulas, AreThoseOfForceAndFactorInWallCoordinates) {
  const Problem p = case_of_formulas(
      "[system]\nforce = 0.2*v + max(v-0.3,0) + y + 0.5*abs(y-0.1)\n[wall]\nright = 0.5\n"
      "right_restitution = 0.9\n[noise]\nintensity = 0.2\nfactor = 2 + abs(y) + abs(v+0.2)\n"
      "interpretation = ito\n");
  const Problem seen = to_wall_coordinates(wall_frame(p.system), p);
  const auto expect_equal = [](const std::vector<double>& found, const std::vector<double>& exact) {
    ASSERT_EQ(found.size(), exact.size());
    for (std::size_t n = 0; n < exact.size(); ++n) EXPECT_NEAR(found[n], exact[n], 1e-9);
  };
  expect_equal(coefficient_kinks_in_y(p, -1, 0.5), {0, 0.1});
  expect_equal(coefficient_kinks_in_v(p, -1, 1), {-0.2, 0.3});
  expect_equal(coefficient_kinks_in_y(seen, 0, 1), {0.4, 0.5});
  expect_equal(coefficient_kinks_in_v(seen, -1, 1), {-0.3, 0.2});
}

TEST(NoiseFactor, IsTransformedToWallCoordinates) {
  const Problem p = case_of_formulas(
      "[system]\nforce = 0.2*v + y\n[wall]\nright = 0.5\n"
      "right_restitution = 0.9\n[noise]\nintensity = 0.2\n"
      "factor = 1.5 + 0.5*tanh(y + 0.3*v)\ninterpretation = stratonovich\n");
  const WallFrame frame = wall_frame(p.system);
  const Problem seen = to_wall_coordinates(frame, p);
  const double x = 0.7, v = -0.4;
  const double y = frame.physical_y(x), physical_v = frame.physical_velocity(v);
  ASSERT_NEAR(y, -0.2, 1e-15);
  ASSERT_NEAR(physical_v, 0.4, 1e-15);
  EXPECT_NEAR((*seen.noise_factor)(x, v), (*p.noise_factor)(y, physical_v), 1e-15);
  EXPECT_NEAR(seen.noise_factor->squared_noise_factor_slope_in_v(x, v),
              -p.noise_factor->squared_noise_factor_slope_in_v(y, physical_v), 1e-15);
  EXPECT_NEAR(seen.system.force(x, v), -p.system.force(y, physical_v), 1e-15);
}

// Damping d(H) = 0.1 + 0.1 H and G = 1 + H/2: exp(-Phi) is the exact density (1 + H/2) exp(-2H) in
// Ito's sense, and (1 + H/2)^(3/2) exp(-2H) in Stratonovich's.
TEST(NoiseFactor, HasTheExactLawOfTheEnergyByAveraging) {
  for (const bool is_force_in_ito_sense : {true, false}) {
    const EnergyAveraging averaging(case_of_formulas(
        kEnergyDamping + kFactor + (is_force_in_ito_sense ? "ito" : "stratonovich")));
    ASSERT_FALSE(averaging.reason_for_unconfined_motion());
    const auto exact = [&](double h) {
      return 2 * h - (is_force_in_ito_sense ? 1 : 1.5) * std::log(1 + h / 2);
    };
    const auto& bands = averaging.energy_bands();
    for (const auto& band : bands) {
      EXPECT_NEAR(band.potential - bands.front().potential,
                  exact(band.energy) - exact(bands.front().energy), 2e-3)
          << band.energy;
    }
  }
}

TEST(NoiseFactor, IsValidated) {
  expect_refusal(kEnergyDamping + "factor = sqrt(1+v^2)\n", "noise.interpretation is missing");
  expect_refusal(kEnergyDamping + "interpretation = ito\n", "without noise.factor");
  expect_refusal(kEnergyDamping + "factor = y\n", "noise.factor = ");
  expect_refusal(kEnergyDamping + "factor = 1 +\n", "noise.factor column 4");
  expect_refusal(
      kLinearSpring + "restitution = 0.9\n" + kUnitImpulses + "[noise]\nfactor = 1 + y^2\n",
      "noise.intensity is 0");
}

const std::string kParametric =
    "[impulse]\nrate = 1\nlaw = exponential\nintensity = 0.2\nfactor = ";

TEST(ImpulseFactor, IsAFormulaOfTheDisplacement) {
  const Problem p = case_of_formulas(kLinearSpring + "[wall]\nnone = true\n" + kParametric +
                                     "1 + a*y\n[parameters]\na = 0.5\n");
  EXPECT_NEAR(squared_impulse_factor(p, 2), 4, 1e-15);
  EXPECT_NE(polynomial_method_unsupported_reason(p).find("impulse.factor"), std::string::npos);
  const Problem again = problem_from_sections("again", case_file_sections(p));
  EXPECT_NEAR(squared_impulse_factor(again, -1), 0.25, 1e-15);
  const Problem without = case_of_formulas(kLinearSpring + "[wall]\nnone = true\n" + kUnitImpulses);
  EXPECT_EQ(squared_impulse_factor(without, 2), 1);
}

// b Y at the physical displacement, with the mirrored amplitude -Y.
TEST(ImpulseFactor, IsTransformedToWallCoordinates) {
  const Problem p =
      case_of_formulas(kLinearSpring + "[wall]\nright = 0.5\nright_restitution = 0.9\n" +
                       kParametric + "1 + 0.5*abs(y-0.2)\n");
  const WallFrame frame = wall_frame(p.system);
  const Problem transformed = to_wall_coordinates(frame, p);
  ASSERT_NEAR(frame.physical_y(0.7), -0.2, 1e-15);
  EXPECT_NEAR(squared_impulse_factor(transformed, 0.7), 1.2 * 1.2, 1e-14);
  EXPECT_LT(transformed.impulses.amplitude_law().moment(3) * p.impulses.amplitude_law().moment(3),
            0);
  ASSERT_EQ(coefficient_kinks_in_y(transformed, 0, 1).size(), 1U);
  EXPECT_NEAR(coefficient_kinks_in_y(transformed, 0, 1)[0], 0.3, 1e-9);
}

// For b = 1 + e y and k = 1 the closed integrals at the energy h are 2 pi c h for the loss and
// lambda E[Y^2]/2 (2 pi h + e^2 pi h^2) for the diffusion.
TEST(ImpulseFactor, EntersEnergyAveraging) {
  const Problem p =
      case_of_formulas(kLinearSpring + "[wall]\nnone = true\n" + kParametric + "1 + 0.3*y\n");
  const UndampedOrbits orbits(p);
  for (const double h : {0.2, 1.5}) {
    const auto orbit = orbits.orbit_integrals(orbits.half_cycles(h).front(), h);
    EXPECT_NEAR(orbit.loss, 0.1 * 2 * std::numbers::pi * h, 1e-9);
    EXPECT_NEAR(orbit.diffusion, 0.1 * std::numbers::pi * (2 * h + 0.09 * h * h), 1e-9);
  }
}

// The power input is lambda E[Y^2] E[b^2] / 2.
TEST(ImpulseFactor, EntersTheBalanceOfPower) {
  const Problem p =
      case_of_formulas(kLinearSpring + "[wall]\nnone = true\n" + kParametric + "1 + 0.3*y\n");
  EXPECT_NEAR(
      power_balance(
          p, {.mean_velocity = 0, .mean_square_velocity = 2, .mean_square_impulse_factor = 1.5})
          .input,
      0.15, 1e-15);
}

TEST(ImpulseFactor, IsValidated) {
  const std::string start = kLinearSpring + "[wall]\nnone = true\n" + kParametric;
  expect_refusal(start + "1 + v\n", "impulse.factor column 5");
  expect_refusal(start + "1 + y\nmean = 0.1\n", "impulse.mean = 0.1");
  expect_refusal(start + "1/y\n", "impulse.factor is not finite at y = 0");
}

TEST(RestitutionFormula, IsAFunctionOfTheImpactSpeed) {
  const Problem p = case_of_formulas(
      kLinearSpring + "[wall]\nleft = 0\nleft_restitution = 1 - a*min(1,abs(v))^0.2\n" +
      kUnitImpulses + "[parameters]\na = 0.3\n");
  const Wall& wall = *p.system.left_wall();
  EXPECT_FALSE(wall.has_constant_restitution());
  EXPECT_EQ(wall.restitution, 1);
  EXPECT_NEAR(wall.restitution_at_speed(0.5), 1 - 0.3 * std::pow(0.5, 0.2), 1e-15);
  EXPECT_NEAR(wall.restitution_at_speed(7), 0.7, 1e-15);
  EXPECT_NEAR(energy_loss_at_impact(wall, ImpactCondition::map, 7), (1 - 0.49) * 49 / 2, 1e-13);
  EXPECT_NEAR(momentum_change_at_impact(wall, 7), 1.7 * 7, 1e-13);
  EXPECT_FALSE(polynomial_method_unsupported_reason(p).empty());
  const Problem again = problem_from_sections("a", case_file_sections(p));
  EXPECT_EQ(again.system.left_wall()->restitution_at_speed(0.5), wall.restitution_at_speed(0.5));
}

TEST(RestitutionFormula, ThatIsConstantIsANumber) {
  const Problem p = case_of_formulas(kLinearSpring + "[wall]\nleft = 0\nleft_restitution = r\n" +
                                     kUnitImpulses + "[parameters]\nr = 0.9\n");
  EXPECT_EQ(p.system.left_wall(), (Wall{0, 0.9}));
  EXPECT_EQ(polynomial_method_unsupported_reason(p), "");
}

// The loss (1 - r(u)^2) u^2 / 2 at the impact speed u of an orbit.
TEST(RestitutionFormula, IsThatOfTheOrbit) {
  const Problem p = case_of_formulas(
      "[system]\ndamping = 0.1\nstiffness = 4\n[wall]\nleft = 0\n"
      "left_restitution = 1 - 0.2*tanh(v)\n" +
      kUnitImpulses);
  const UndampedOrbits orbits(p);
  const double u = 1.1;
  const OrbitIntegrals orbit = orbits.orbit_integrals(orbits.half_cycles(u * u / 2)[0], u * u / 2);
  const double r = 1 - 0.2 * std::tanh(u);
  EXPECT_NEAR(orbit.loss - 0.1 * orbit.action, (1 - r * r) * u * u / 2, 1e-13);
}

TEST(RestitutionFormula, IsValidated) {
  const auto wall = [](const std::string& restitution) {
    return kLinearSpring + "[wall]\nleft = 0\nleft_restitution = " + restitution + "\n" +
           kUnitImpulses;
  };
  expect_refusal(wall("1.2"), "wall.left_restitution = 1.2 (must be");
  expect_refusal(wall("1 + 0.1"), "wall.left_restitution = 1.1 (must be");
  expect_refusal(wall("1 - v"), "at the impact speed");
  expect_refusal(wall("exp(-2*v)"), "decreases at the impact speed");
  expect_refusal(wall("1 - y"), "column 5");
}

}  // namespace
}  // namespace fpkcheck::problem
