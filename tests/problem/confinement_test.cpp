#include "problem/confinement.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/input_error.hpp"
#include "general_oscillators.hpp"

namespace fpkcheck::problem {
namespace {

const WallParameters kNone{.none = true};
WallParameters left(double position, double restitution) {
  return {.left = position, .left_restitution = restitution};
}

std::string refusal(const SystemCoefficients& coefficients, const WallParameters& walls = kNone,
                    double mean_impulse = 0) {
  try {
    require_stationary_density(tests::with_impulses(System(coefficients, walls),
                                                    tests::gaussian_impulses(1, 1, mean_impulse)));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
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
