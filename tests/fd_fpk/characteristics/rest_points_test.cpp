#include "fd_fpk/characteristics/rest_points.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::fd_fpk {
namespace {

using problem::System;

TEST(RestPoints, AreContactsUnderAForceTowardsAWallAndEquilibriaElsewhere) {
  const auto preload = find_rest_points(
      DeterministicFlow(System({.damping = 0.1, .constant = 0.5, .restitution = 0.7})));
  ASSERT_EQ(preload.size(), 1u);
  EXPECT_EQ(preload[0].y, 0);
  EXPECT_EQ(preload[0].contact, WallSide::left);

  const auto stops = find_rest_points(DeterministicFlow(
      System({.damping = 0.1, .stiffness = -1, .cubic = 1},
             {.left = -0.5, .left_restitution = 0.7, .right = 0.5, .right_restitution = 0.7})));
  ASSERT_EQ(stops.size(), 2u);
  EXPECT_EQ(stops[0].contact, WallSide::left);
  EXPECT_EQ(stops[1].contact, WallSide::right);

  // The wall on the right lies outside the well at 1, the wall on the left inside that at -1.
  const auto one = find_rest_points(DeterministicFlow(
      System({.damping = 0.1, .stiffness = -1, .cubic = 1},
             {.left = -0.5, .left_restitution = 0.7, .right = 2, .right_restitution = 0.7})));
  ASSERT_EQ(one.size(), 2u);
  EXPECT_EQ(one[0].contact, WallSide::left);
  EXPECT_FALSE(one[1].contact);
  EXPECT_DOUBLE_EQ(one[1].y, 1);
}

TEST(RestPoints, AreNoContactsWithoutLossesOrForce) {
  const auto elastic = find_rest_points(
      DeterministicFlow(System({.damping = 0.1, .constant = 0.5, .restitution = 1})));
  ASSERT_EQ(elastic.size(), 1u);
  EXPECT_FALSE(elastic[0].contact);
  const auto at_wall = find_rest_points(
      DeterministicFlow(System({.damping = 0.1, .stiffness = 1, .restitution = 0.7})));
  ASSERT_EQ(at_wall.size(), 1u);
  EXPECT_EQ(at_wall[0].y, 0);
  EXPECT_FALSE(at_wall[0].contact);
  // A maximum of the potential at the wall is not a rest point.
  const auto hill = find_rest_points(
      DeterministicFlow(System({.damping = 0.1, .stiffness = -1, .cubic = 1, .restitution = 0.7})));
  ASSERT_EQ(hill.size(), 1u);
  EXPECT_DOUBLE_EQ(hill[0].y, 1);
}

// The sum impact by impact.
TEST(ImpactCascade, IsTheSumOverItsImpacts) {
  const double g = 1.3, r = 0.6, rate = 0.9, speed = 0.2;
  double time = 0, momentum = 0, energy = 0;
  for (double u = speed; u > 1e-18; u *= r) {
    time += 2 * u / g;
    momentum += u;
    energy += u * u;
  }
  const ImpactCascade sum = impact_cascade(speed, g, r, rate);
  EXPECT_NEAR(sum.rest_probability, std::exp(-rate * time), 1e-14);
  EXPECT_NEAR(sum.momentum, momentum, 1e-14);
  EXPECT_NEAR(sum.energy, energy, 1e-14);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
