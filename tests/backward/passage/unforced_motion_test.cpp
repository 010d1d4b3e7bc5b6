#include "backward/passage/unforced_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "problem/system.hpp"

namespace fpkcheck::backward {
namespace {

constexpr double kLongDuration = 100;

double sum_of_weights(const UnforcedTrajectory& trajectory) {
  return std::accumulate(
      trajectory.nodes.begin(), trajectory.nodes.end(), 0.0,
      [](double sum, const TrajectoryQuadratureNode& node) { return sum + node.weight; });
}

// Linear oscillator with damping 0.2 and stiffness 4 from the state (y, v)
PhaseState damped_state(double y, double v, double t) {
  const double decay = 0.1, frequency = std::sqrt(4 - decay * decay);
  const double a = y, b = (v + decay * y) / frequency;
  const double c = std::cos(frequency * t), s = std::sin(frequency * t), e = std::exp(-decay * t);
  return {e * (a * c + b * s),
          e * ((b * frequency - decay * a) * c - (a * frequency + decay * b) * s)};
}

TEST(UnforcedMotion, FollowsTheExactSolutionUntilTheExit) {
  const problem::System system({.damping = 0.2, .stiffness = 4}, {.none = true});
  const UnforcedMotionSolver solver(system, 1, 1, 0.3, 1);
  const UnforcedTrajectory found = solver.compute_trajectory({0.5, -2.5}, kLongDuration);
  ASSERT_TRUE(found.passed_barrier);
  const PhaseState at_exit = damped_state(0.5, -2.5, found.duration);
  EXPECT_NEAR(at_exit.y, 1, 1e-12);
  EXPECT_NEAR(found.end_state.v, at_exit.v, 1e-12);
  EXPECT_GT(found.end_state.v, 0.1);
  EXPECT_NEAR(sum_of_weights(found), found.duration, 1e-9);
  double integral = 0, error = 0;
  for (const TrajectoryQuadratureNode& node : found.nodes) {
    const PhaseState exact = damped_state(0.5, -2.5, node.time);
    error = std::max({error, std::abs(node.state.y - exact.y), std::abs(node.state.v - exact.v)});
    // d/dt (1 - y)^(3/2) = -(3/2) (1 - y)^(1/2) v
    integral += node.weight * 1.5 * std::sqrt(1 - node.state.y) * node.state.v;
  }
  EXPECT_LT(error, 1e-12);
  EXPECT_NEAR(integral, std::pow(0.5, 1.5), 1e-9);
}

// Damping c(y) = 0.1 + 0.2 y^2 and 0.05 v^3, and all powers of the force: the derivative of the
// energy is minus the dissipated power.
TEST(UnforcedMotion, DissipatesTheEnergyOfAllTermsOfThePolynomials) {
  const problem::System system({.damping = 0.1,
                                .van_der_pol = 0.2,
                                .rayleigh = 0.05,
                                .constant = 0.1,
                                .stiffness = 1,
                                .quadratic = 0.3,
                                .cubic = 0.4,
                                .quintic = 0.5},
                               {.left = -1, .left_restitution = 0.8});
  const UnforcedMotionSolver solver(system, 3, 4, 0.3, 1);
  const PhaseState start{0.3, -0.6};  // turns before the wall
  const UnforcedTrajectory found = solver.compute_trajectory(start, 1);
  const auto energy = [&](const PhaseState& at) {
    return at.v * at.v / 2 + system.potential()(at.y);
  };
  double dissipated = 0;
  for (const TrajectoryQuadratureNode& node : found.nodes) {
    const auto [y, v] = node.state;
    dissipated += node.weight * (system.damping_polynomial()(y) * v * v + 0.05 * std::pow(v, 4));
  }
  EXPECT_NEAR(found.duration, 1, 1e-12);
  EXPECT_GT(dissipated, 1e-3);
  EXPECT_NEAR(energy(start) - energy(found.end_state), dissipated, 1e-10);
}

// Without damping a linear oscillator with a wall at its equilibrium returns after half a period,
// with r times its speed; the last impact of this test is at the time 3 pi / 2.
TEST(UnforcedMotion, ReboundsWithTheRestitutionCoefficient) {
  const problem::System system({.damping = 0, .stiffness = 4},
                               {.left = 0, .left_restitution = 0.5});
  const UnforcedMotionSolver solver(system, 2, 2, 0.3, 1);
  const UnforcedTrajectory found = solver.compute_trajectory({0, 2}, 1.5 * std::numbers::pi + 0.25);
  EXPECT_FALSE(found.passed_barrier);
  EXPECT_NEAR(found.end_state.v, 0.25 * std::cos(0.5), 1e-10);
  EXPECT_NEAR(found.end_state.y, 0.125 * std::sin(0.5), 1e-10);
  // A force towards the wall ends the impacts at rest after a finite time.
  const problem::System falling({.damping = 0, .constant = 1, .stiffness = 1},
                                {.left = 0, .left_restitution = 0.5});
  const UnforcedTrajectory ended =
      UnforcedMotionSolver(falling, 2, 2, 0.3, 1).compute_trajectory({0, 0.5}, kLongDuration);
  EXPECT_EQ(ended.end_state.y, 0);
  EXPECT_LT(ended.duration, 3);
}

TEST(UnforcedMotion, FindsTheVelocitiesOfTheGrazingMotion) {
  const problem::System system({.damping = 0.1, .stiffness = 1, .cubic = 0.3},
                               {.left = 0, .left_restitution = 0.7});
  const UnforcedMotionSolver solver(system, 1.5, 1.5, 0.3, 1);
  const std::vector<double> velocities =
      solver.find_backward_crossing_velocities({1.5, 0}, 0.6, kLongDuration, 100);
  ASSERT_EQ(velocities.size(), 2u);  // on the way to the barrier, and on the way to the wall
  EXPECT_GT(velocities[0], 0);
  EXPECT_LT(velocities[1], 0);
  for (const double v : velocities) {
    const double faster = v + std::copysign(1e-6, v), slower = v - std::copysign(1e-6, v);
    EXPECT_TRUE(solver.compute_trajectory({0.6, faster}, 5).passed_barrier) << v;
    EXPECT_FALSE(solver.compute_trajectory({0.6, slower}, 5).passed_barrier) << v;
  }
  EXPECT_GT(solver.find_largest_backward_speed({1.5, 0}, kLongDuration, 100), -velocities[1]);
}

// Without damping and losses the linear oscillator that grazes y = 1.5 turns there in each period.
// With a restitution coefficient r the displacement of the preceding turning point is 1.5 / r.
TEST(UnforcedMotion, FindsTheTurningPointsOfTheGrazingMotion) {
  const problem::System system({.damping = 0, .stiffness = 4},
                               {.left = 0, .left_restitution = 0.8});
  const UnforcedMotionSolver solver(system, 1.5, 1.5, 0.3, 1, BarrierKind::permeable);
  const std::vector<double> displacements = solver.find_backward_turning_points({1.5, 0}, 3.5, 100);
  ASSERT_EQ(displacements.size(), 2u);
  EXPECT_NEAR(displacements[0], 1.5 / 0.8, 1e-10);
  EXPECT_NEAR(displacements[1], 1.5 / 0.64, 1e-10);
}

}  // namespace
}  // namespace fpkcheck::backward
