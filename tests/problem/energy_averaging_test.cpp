#include "problem/energy_averaging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "general_oscillators.hpp"
#include "problem/problem.hpp"
#include "refusal.hpp"

namespace fpkcheck::problem {
namespace {

const WallParameters kNone{.none = true};

TEST(EffectivePotential, HasTheForceAndTheMeanOfTheImpulsesForItsSlope) {
  const Problem p = tests::with_impulses(System({.stiffness = 1, .cubic = 0.3}, kNone),
                                         tests::gaussian_impulses(2, 0.3, 0.12));
  const numerics::Polynomial slope = effective_potential_polynomial(p).derivative();
  for (const double y : {-0.7, 0.0, 1.3}) {
    EXPECT_NEAR(slope(y), p.system.restoring_force()(y) - p.impulses.rate_times_moment(1), 1e-15);
  }
  EXPECT_EQ(UndampedOrbits(p).potential().polynomial_or_null()->coefficients(),
            effective_potential_polynomial(p).coefficients());
}

TEST(UndampedOrbits, OfAHarmonicSpringHaveItsPeriodAndAction) {
  const Problem p = tests::with_noise(System({.damping = 0.2, .stiffness = 4}, kNone), 1);
  const UndampedOrbits orbits(p);
  ASSERT_EQ(orbits.potential_minima(), std::vector<double>{0});
  const double energy = 0.7;
  const auto half_cycles = orbits.half_cycles(energy);
  ASSERT_EQ(half_cycles.size(), 1u);
  EXPECT_NEAR(half_cycles[0].right, std::sqrt(2 * energy) / 2, 1e-13);
  const OrbitIntegrals orbit = orbits.orbit_integrals(half_cycles[0], energy);
  EXPECT_NEAR(orbit.period, std::numbers::pi, 1e-12);
  // The action is the area inside the orbit: 2 pi energy / frequency.
  EXPECT_NEAR(orbit.action, energy * std::numbers::pi, 1e-12);
  EXPECT_NEAR(orbit.loss, 0.2 * orbit.action, 1e-13);
  EXPECT_NEAR(orbit.time_integral_y2 / orbit.period, energy / 4, 1e-12);
}

TEST(UndampedOrbits, DissipateAtEachWallTheyReach) {
  // Free flight in a box: at speed u each wall is hit once per period 2 L / u.
  const Problem p = tests::with_noise(
      System({}, {.left = -1, .left_restitution = 0.7, .right = 2, .right_restitution = 0.9}), 1);
  const UndampedOrbits orbits(p);
  const double u = 1.3;
  const auto half_cycles = orbits.half_cycles(u * u / 2);
  ASSERT_EQ(half_cycles.size(), 1u);
  EXPECT_TRUE(half_cycles[0].left_is_wall && half_cycles[0].right_is_wall);
  const OrbitIntegrals orbit = orbits.orbit_integrals(half_cycles[0], u * u / 2);
  EXPECT_NEAR(orbit.period, 6 / u, 1e-12);
  EXPECT_NEAR(orbit.action, 6 * u, 1e-12);
  EXPECT_NEAR(orbit.loss, ((1 - 0.49) + (1 - 0.81)) * u * u / 2, 1e-14);
}

TEST(UndampedOrbits, OfTwoWellsMergeAboveTheSaddle) {
  const UndampedOrbits orbits(
      tests::with_noise(System({.damping = 0.1, .stiffness = -1, .cubic = 1}, kNone), 1));
  ASSERT_EQ(orbits.potential_minima().size(), 2u);
  EXPECT_NEAR(orbits.potential_minima()[0], -1, 1e-12);
  EXPECT_NEAR(orbits.lowest_potential(), -0.25, 1e-12);
  EXPECT_EQ(orbits.half_cycles(-0.1).size(), 2u);
  EXPECT_EQ(orbits.half_cycles(0.1).size(), 1u);
}

TEST(UndampedOrbits, PressedToAWallHaveTheirMinimumThere) {
  const System ball({.constant = 1}, {.left = 0, .left_restitution = 0.7});
  EXPECT_EQ(UndampedOrbits(tests::with_noise(ball, 1)).potential_minima(), std::vector<double>{0});
  // Two wells with walls between the potential minima and the origin.
  const System stops(
      {.damping = 0.1, .stiffness = -1, .cubic = 1},
      {.left = -0.5, .left_restitution = 0.7, .right = 0.5, .right_restitution = 0.7});
  EXPECT_EQ(UndampedOrbits(tests::with_noise(stops, 1)).potential_minima(),
            (std::vector<double>{-0.5, 0.5}));
}

TEST(EnergyAveraging, IsTheExactDensityUnderNoiseAndLinearDamping) {
  // The stationary density is exp(-(c/D) h) for any spring.
  const Problem p =
      tests::with_noise(System({.damping = 0.1, .stiffness = -1, .cubic = 1}, kNone), 0.05);
  const EnergyAveraging averaging(p);
  ASSERT_FALSE(averaging.reason_for_unconfined_motion());
  double total = 0;
  for (const auto& band : averaging.energy_bands()) {
    // The tolerance is half the width of a band.
    EXPECT_NEAR(band.potential, 0.1 / 0.025 * (band.energy + 0.25), 0.25);
    total += band.mass;
  }
  EXPECT_NEAR(total, 1, 1e-12);
}

TEST(EnergyAveraging, HasItsMinimumOnTheLimitCycle) {
  // y'' + (R - 1) y' + y, R = y^2 + y'^2 = 2h: Phi = (R^2/2 - R) / Q.
  const Problem p = tests::with_noise(
      System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, kNone), 0.4);
  const EnergyAveraging averaging(p);
  for (const auto& band : averaging.energy_bands()) {
    const double ring = 2 * band.energy;
    EXPECT_NEAR(band.potential, (ring * ring / 2 - ring + 0.5) / 0.4, 0.02) << ring;
  }
}

TEST(EnergyAveraging, RelaxesAsTheEnergyOfALinearOscillatorDoes) {
  const Problem p = tests::with_noise(System({.damping = 0.1, .stiffness = 4}, kNone), 1);
  EXPECT_NEAR(EnergyAveraging(p).relaxation_rate(), 0.1, 0.002);
}

TEST(EnergyAveraging, RelaxesTheMassesOfWellsByKramersLaw) {
  // Kramers' rate under weak damping is (omega S / 2 pi) (c / T) exp(-barrier / T), S the action of
  // the separatrix inside the well (4/3 of y^4/4 - y^2/2). Half of the trajectories that reach the
  // saddle return, and two wells relax with twice the rate of one.
  const double c = 0.01, T = 0.025, barrier = 0.25;
  const Problem p =
      tests::with_noise(System({.damping = c, .stiffness = -1, .cubic = 1}, kNone), 2 * c * T);
  const double omega = std::sqrt(2.0), action = 4.0 / 3;
  const double rate = omega / (2 * std::numbers::pi) * c / T * action * std::exp(-barrier / T) / 2;
  EXPECT_NEAR(EnergyAveraging(p).relaxation_rate() / (2 * rate), 1, 0.2);
}

WallParameters left(double position, double restitution) {
  return {.left = position, .left_restitution = restitution};
}

std::string refusal(const SystemCoefficients& coefficients, const WallParameters& walls = kNone,
                    double mean_impulse = 0) {
  return tests::refusal([&] {
    require_stationary_density(tests::with_impulses(System(coefficients, walls),
                                                    tests::gaussian_impulses(1, 1, mean_impulse)));
  });
}

const std::string kLeft = "does not confine the mass on the left", kRight = "on the right";
const std::string kEnergy = "dissipate no energy";

TEST(Confinement, NeedsRestoringForceAtOpenEnds) {
  EXPECT_EQ(refusal({.damping = 0.1, .stiffness = -1, .cubic = 1}), "accepted");
  EXPECT_NE(refusal({.damping = 0.1, .stiffness = 1, .cubic = -1}).find(kLeft), std::string::npos);
  EXPECT_NE(refusal({.damping = 0.1, .stiffness = 1, .cubic = -1}, left(0, 1)).find(kRight),
            std::string::npos);
  EXPECT_EQ(refusal({.damping = 0.1, .stiffness = 1, .cubic = -1, .quintic = 0.1}), "accepted");
  EXPECT_NE(refusal({.damping = 0.1, .quadratic = 1}).find(kLeft), std::string::npos);
  EXPECT_EQ(refusal({.damping = 0.1, .quadratic = 1}, left(-1, 1)), "accepted");
  EXPECT_NE(refusal({.damping = 0.1}).find(kLeft), std::string::npos);
}

TEST(Confinement, CountsTheMeanOfTheImpulsesAsAForce) {
  const SystemCoefficients ball{.damping = 0.1, .constant = 1};
  EXPECT_EQ(refusal(ball, left(0, 1), 0.5), "accepted");
  EXPECT_EQ(refusal(ball, left(0, 1), 0.9), "accepted");
  const SystemCoefficients lighter{.damping = 0.1, .constant = 0.4};
  EXPECT_NE(refusal(lighter, left(0, 1), 0.5).find(kRight), std::string::npos);
}

TEST(Confinement, NeedsDissipationAtLargeAmplitudes) {
  const SystemCoefficients undamped{.damping = 0, .stiffness = 1};
  EXPECT_NE(refusal(undamped).find(kEnergy), std::string::npos);
  EXPECT_NE(refusal(undamped, left(0, 1)).find(kEnergy), std::string::npos);
  EXPECT_EQ(refusal(undamped, left(0, 0.9)), "accepted");
  // Density exp(-C sqrt h)
  EXPECT_EQ(refusal({.damping = 0, .constant = 1}, left(0, 0.9)), "accepted");
  // A mass between two walls loses (1 - r^2) u^2/2 at each impact, and impacts are more frequent at
  // higher speeds u.
  EXPECT_EQ(refusal({}, {.left = -1, .left_restitution = 0.9, .right = 1, .right_restitution = 1}),
            "accepted");
}

TEST(Confinement, ComparesNegativeAndPositiveDampingAtLargeEnergies) {
  EXPECT_EQ(refusal({.damping = -1, .van_der_pol = 1, .stiffness = 1}), "accepted");
  EXPECT_EQ(refusal({.damping = -1, .rayleigh = 0.01, .stiffness = 1}), "accepted");
  EXPECT_NE(refusal({.damping = 1, .van_der_pol = -0.01, .stiffness = 1}).find(kEnergy),
            std::string::npos);
  // Over a harmonic period the means of y^2 v^2 and v^4 have the ratio 1 : 3, so c_yy competes with
  // 3 c_vv.
  EXPECT_EQ(refusal({.damping = 1, .van_der_pol = -2.9, .rayleigh = 1, .stiffness = 1}),
            "accepted");
  EXPECT_NE(
      refusal({.damping = 1, .van_der_pol = -3.1, .rayleigh = 1, .stiffness = 1}).find(kEnergy),
      std::string::npos);
}

TEST(Confinement, IsIndependentOfUnits) {
  // The same problem in units in which lengths are multiplied by 1e6 and times by 1e-5.
  const double l = 1e6, t = 1e-5;
  EXPECT_EQ(refusal({.damping = -1 / t, .van_der_pol = 1 / (t * l * l), .stiffness = 1 / (t * t)}),
            "accepted");
  EXPECT_NE(
      refusal({.damping = 1 / t, .van_der_pol = -0.01 / (t * l * l), .stiffness = 1 / (t * t)})
          .find(kEnergy),
      std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::problem
