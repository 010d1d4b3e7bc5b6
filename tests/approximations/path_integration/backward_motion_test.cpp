#include "approximations/path_integration/backward_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::path_integration {
namespace {

using problem::System;

constexpr double kRounding = 1e-9;

// y = exp(-c t/2) (y0 cos wt + ..), and the density grows by exp(c t).
TEST(BackwardMotion, ReversesTheLinearMotion) {
  constexpr double kDamping = 0.2, kTime = 0.7;
  const System system({.damping = kDamping, .stiffness = 1}, {.none = true});
  const double w = std::sqrt(1 - kDamping * kDamping / 4);
  const auto state = earlier_state(system, 0.3, -0.4, kTime, 0.02);
  const double decay = std::exp(-kDamping * kTime / 2);
  const double a = (state.v + kDamping / 2 * state.y) / w;
  EXPECT_NEAR(decay * (state.y * std::cos(w * kTime) + a * std::sin(w * kTime)), 0.3, kRounding);
  EXPECT_NEAR(state.growth, std::exp(kDamping * kTime), kRounding);
}

// Free flight between two walls: the speed after each impact is r times the speed before.
TEST(BackwardMotion, ReversesImpactsOnTwoWalls) {
  const System system({},
                      {.left = -1, .left_restitution = 0.5, .right = 1, .right_restitution = 0.8});
  // Backwards from y = 0, v = 1: left wall after the time 1, there v = -1/0.5; right wall after the
  // time 1 + 2/2, there v = 2/0.8 = 2.5; then for the time 0.4.
  const auto state = earlier_state(system, 0, 1, 2.4, 0.03);
  EXPECT_NEAR(state.y, 1 - 2.5 * 0.4, kRounding);
  EXPECT_NEAR(state.v, 2.5, kRounding);
  EXPECT_NEAR(state.growth, 1 / (0.5 * 0.5 * 0.8 * 0.8), kRounding);
}

// Bouncing under gravity g = 1: the flight before the impact with the speed u takes the time 2u.
TEST(BackwardMotion, ReversesShortFlights) {
  const System system({.constant = 1, .restitution = 0.5});
  // Speeds 0.01 after and 0.02 before the last impact, then a flight of the time 0.04, and speeds
  // 0.02 after and 0.04 before the first impact.
  const auto state = earlier_state(system, 0, 0.01, 0.04 + 0.02, 0.05);
  EXPECT_NEAR(state.v, -0.04 + 0.02, kRounding);
  EXPECT_NEAR(state.y, 0.04 * 0.02 - 0.02 * 0.02 / 2, kRounding);
  EXPECT_NEAR(state.growth, 16, 1e-7);
}

// w = u r(u) = u (1 - 0.2 u): dw/du = 1 - 0.4 u, and the growth is u / (w dw/du).
TEST(BackwardMotion, DifferentiatesAFormulaOfRestitution) {
  const System system({},
                      {.left = 0, .left_restitution = base::NumberOrFormula("1 - 0.2*min(v, 1)")});
  constexpr double kBefore = 0.5, kAfter = kBefore * (1 - 0.2 * kBefore);
  const auto state = earlier_state(system, 0.1 * kAfter, kAfter, 0.3, 0.05);
  EXPECT_NEAR(state.y, 0.2 * kBefore, kRounding);
  EXPECT_NEAR(state.v, -kBefore, kRounding);
  EXPECT_NEAR(state.growth, kBefore / (kAfter * (1 - 0.4 * kBefore)), 1e-7);
}

}  // namespace
}  // namespace fpkcheck::path_integration
