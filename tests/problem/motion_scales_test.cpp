#include "problem/motion_scales.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "general_oscillators.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::problem {
namespace {

TEST(MotionScales, OfThePapersClassAreThoseOfEquivalentLinearisation) {
  const Problem p = tests::paper_case(1);
  const auto linear = equivalent_linearisation(p);
  const MotionScales s = motion_scales(p);
  EXPECT_EQ(s.displacement_deviation, linear.displacement_deviation);
  EXPECT_EQ(s.velocity_deviation, linear.velocity_deviation);
  EXPECT_EQ(s.y_high, 7 * linear.displacement_deviation);
  EXPECT_EQ(s.slowest_decay_rate, slowest_decay_rate(linear));
}

TEST(MotionScales, OfALinearOscillatorWithoutWallsAreItsDeviations) {
  // E[v^2] = 2D/(2c), E[y^2] = E[v^2]/k about the mean force.
  const Problem p = tests::with_noise(
      System({.damping = 0.1, .constant = -4, .stiffness = 4}, {.none = true}), 0.8);
  const MotionScales s = motion_scales(p);
  EXPECT_NEAR(s.velocity_deviation, 2, 0.02);
  EXPECT_NEAR(s.displacement_deviation, 1, 0.01);
  EXPECT_NEAR(s.centre, 1, 1e-6);
  EXPECT_NEAR(s.y_high, 1 + 7, 0.1);
  EXPECT_NEAR(s.y_low, 1 - 7, 0.1);
  EXPECT_NEAR(s.v_high, 14, 0.2);
  EXPECT_NEAR(s.frequency, 2, 1e-9);
  EXPECT_NEAR(s.slowest_decay_rate, 0.05, 0.001);
}

TEST(MotionScales, OfACreepingOscillatorDecayAsItCreeps) {
  const Problem p = tests::with_noise(System({.damping = 20, .stiffness = 4}, {.none = true}), 0.8);
  EXPECT_NEAR(motion_scales(p).slowest_decay_rate, 4.0 / 20, 0.01);
}

TEST(MotionScales, EndAtWalls) {
  const Problem p = tests::with_noise(
      System({.stiffness = 1},
             {.left = -1, .left_restitution = 0.7, .right = 0.5, .right_restitution = 1}),
      10);
  const MotionScales s = motion_scales(p);
  EXPECT_EQ(s.y_low, -1);
  EXPECT_EQ(s.y_high, 0.5);
}

}  // namespace
}  // namespace fpkcheck::problem
