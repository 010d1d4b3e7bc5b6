#include "fd_fpk/characteristics/deterministic_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

// y'' + c y' + k y = 0 from the wall.
TEST(Flow, HalfCycleOfTheLinearOscillatorAgreesWithItsFormulas) {
  const double c = 0.6, k = 2, v = 1.3;
  const DeterministicFlow flow(
      tests::make_problem({.damping = c, .stiffness = k, .cubic = 0}).system);
  const double w = std::sqrt(k - c * c / 4);
  const auto half_cycle = flow.half_cycle(v);
  EXPECT_NEAR(half_cycle.duration, std::numbers::pi / w, 3e-6);
  EXPECT_NEAR(half_cycle.impact_speed, v * std::exp(-c / 2 * std::numbers::pi / w), 3e-6);
  const double top = std::atan(2 * w / c) / w;
  EXPECT_NEAR(half_cycle.height, v / w * std::exp(-c / 2 * top) * std::sin(w * top), 1e-4);
}

TEST(Flow, OverdampedMotionDoesNotReturn) {
  const DeterministicFlow flow(tests::make_problem({.damping = 5, .cubic = 0}).system);
  const auto half_cycle = flow.half_cycle(1);
  EXPECT_TRUE(std::isinf(half_cycle.duration));
  EXPECT_EQ(half_cycle.impact_speed, 0);
  EXPECT_GT(half_cycle.height, 0.1);
}

// Steps become much longer than 1/c, and remain accurate.
TEST(Flow, OverdampedMotionIsAccurateOverLongTimes) {
  const auto follow = [](const DeterministicFlow& flow, PhaseState state, double until) {
    double time = 0, longest = 0;
    for (int step = 0; time < until; ++step) {
      EXPECT_LT(step, 400);
      if (step >= 400) break;
      const double span =
          std::min(flow.max_time_step(state, flow.accessible_displacements(state)), until - time);
      longest = std::max(longest, span);
      state = flow.advance_state(state, span);
      time += span;
    }
    EXPECT_GT(longest * flow.contraction_rate(state), 5);
    return state;
  };
  {
    // Towards rest with roots s1, s2 of s^2 + c s + k = 0.
    const double c = 50, k = 2, s2 = -(c + std::sqrt(c * c - 4 * k)) / 2, s1 = k / s2;
    const DeterministicFlow flow(
        tests::make_problem({.damping = c, .stiffness = k, .cubic = 0}).system);
    const PhaseState end = follow(flow, {0, 3}, 80);
    const double expected = 3 / (s1 - s2) * std::exp(s1 * 80);
    EXPECT_NEAR(end.y / expected, 1, 1e-4);
    EXPECT_NEAR(end.v / (s1 * expected), 1, 1e-4);
  }
  {
    // y' = -mu y^3 / c (1 + O(mu y^2 / c^2)).
    const double c = 40, mu = 3;
    const DeterministicFlow flow(
        tests::make_problem({.damping = c, .stiffness = 0, .cubic = mu}).system);
    const double y0 = 0.1, until = 1e6;
    const PhaseState end = follow(flow, {y0, -mu / c * y0 * y0 * y0}, until);
    const double expected = y0 / std::sqrt(1 + 2 * mu / c * y0 * y0 * until);
    EXPECT_NEAR(end.y / expected, 1, 1e-3);
    EXPECT_NEAR(end.v / (-mu / c * std::pow(expected, 3)), 1, 3e-3);
  }
}

// mu y^4 / 4 = v^2 / 2 at the apex of a flight without losses.
TEST(Flow, TurningPointOfAHardSpringFollowsFromItsEnergy) {
  const double mu = 7, v = 3;
  const DeterministicFlow flow(
      tests::make_problem({.damping = 1e-9, .stiffness = 0, .cubic = mu}).system);
  const auto half_cycle = flow.half_cycle(v);
  EXPECT_NEAR(half_cycle.height, std::pow(2 * v * v / mu, 0.25), 1e-4);
  EXPECT_NEAR(half_cycle.impact_speed / v, 1, 3e-5);
}

TEST(Flow, StepsKeepTheEnergyOfAnUndampedMotion) {
  const DeterministicFlow flow(tests::make_problem({.damping = 1e-12, .cubic = 3}).system);
  PhaseState state{0.2, 1.1};
  const double energy = flow.mechanical_energy(state);
  for (int step = 0; step < 100; ++step) {
    state =
        flow.advance_state(state, flow.max_time_step(state, flow.accessible_displacements(state)));
    if (state.y < 0) state = {-state.y, -state.v};  // the odd continuation
  }
  EXPECT_NEAR(flow.mechanical_energy(state) / energy, 1, 3e-5);
}

TEST(Flow, ImpactTimeGivesThePositionOfTheWall) {
  const DeterministicFlow flow(tests::paper_case(2).system);
  const PhaseState from{0.05, -0.7};
  ASSERT_LT(flow.advance_state(from, 0.1).y, 0);
  const double time = flow.impact_time(from, 0.1, WallSide::left);
  EXPECT_NEAR(flow.advance_state(from, time).y, 0, 1e-14);
}

// For a constant force g0: heights u^2 / (2 g0), times 2 u / g0.
TEST(Flow, BallFliesAlongParabolas) {
  const double g0 = 1.7, u = 0.3;
  const DeterministicFlow flow(problem::System({.constant = g0, .restitution = 0.7}));
  const auto half_cycle = flow.half_cycle(u);
  EXPECT_NEAR(half_cycle.duration, 2 * u / g0, 1e-12);
  EXPECT_NEAR(half_cycle.height, u * u / (2 * g0), 1e-12);
  EXPECT_NEAR(half_cycle.impact_speed, u, 1e-12);
}

TEST(Flow, MeetsTheWallOnTheRightToo) {
  const DeterministicFlow flow(
      problem::System({.damping = 0.1, .stiffness = 1}, {.right = 0.5, .right_restitution = 0.7}));
  const PhaseState from{0.45, 0.7};
  ASSERT_EQ(flow.wall_passed_by_displacement(flow.advance_state(from, 0.1).y), WallSide::right);
  const double time = flow.impact_time(from, 0.1, WallSide::right);
  EXPECT_NEAR(flow.advance_state(from, time).y, 0.5, 1e-14);
  EXPECT_FALSE(flow.wall_passed_by_displacement(0.5));
  EXPECT_FALSE(flow.wall_passed_by_displacement(-10));
}

// U = -y^2/2 + y^4/4: wells of depth 1/4 at +-1, g' = 2 there.
TEST(Flow, AccessibleIntervalIsOneWellBelowTheSaddleAndBothAbove) {
  const DeterministicFlow flow(
      problem::System({.damping = 0.1, .stiffness = -1, .cubic = 1}, {.none = true}));
  const AccessibleDisplacements below = flow.accessible_displacements({1, 0.1});
  EXPECT_GT(below.low, 0.9);
  EXPECT_LT(below.high, 1.1);
  EXPECT_NEAR(flow.mechanical_energy({below.low, 0}), flow.mechanical_energy({1, 0.1}), 1e-8);
  EXPECT_NEAR(flow.mechanical_energy({below.high, 0}), flow.mechanical_energy({1, 0.1}), 1e-8);
  EXPECT_DOUBLE_EQ(below.least_potential, -0.25);
  EXPECT_NEAR(below.frequency, std::sqrt(2), 0.15);
  const AccessibleDisplacements above = flow.accessible_displacements({1, 1});
  EXPECT_NEAR(above.low, -above.high, 1e-8);
  EXPECT_NEAR(flow.mechanical_energy({above.high, 0}), 0.25, 1e-8);
}

// The contraction rate of areas is minus the divergence of the flow; compared with differences of
// the flow.
TEST(Flow, ContractionIsMinusTheDivergence) {
  const DeterministicFlow flow(problem::System(
      {.damping = 0.3, .van_der_pol = 0.7, .rayleigh = 0.2, .stiffness = 1, .cubic = 2},
      {.none = true}));
  const PhaseState at{0.6, -0.8};
  const double h = 1e-5;
  const double slope =
      (flow.acceleration({at.y, at.v + h}) - flow.acceleration({at.y, at.v - h})) / (2 * h);
  EXPECT_NEAR(flow.contraction_rate(at), -slope, 1e-8);
}

// y'' + c(y) y' + k y = 0 far above critical damping: long steps against short steps.
TEST(Flow, OverdampedMotionIsAccurateForDampingThatDependsOnDisplacement) {
  const DeterministicFlow flow(
      problem::System({.damping = 30, .van_der_pol = 40, .stiffness = 1}, {.none = true}));
  PhaseState state{1, -1 / 70.0}, fine = state;
  double time = 0;
  for (int step = 0; time < 40 && step < 5000; ++step) {
    const double span =
        std::min(flow.max_time_step(state, flow.accessible_displacements(state)), 40 - time);
    state = flow.advance_state(state, span);
    time += span;
  }
  ASSERT_DOUBLE_EQ(time, 40);
  for (int step = 0; step < 8000; ++step) fine = flow.advance_state(fine, 40 / 8000.0);
  EXPECT_NEAR(state.y / fine.y, 1, 1e-3);
  EXPECT_NEAR(state.v / fine.v, 1, 1e-2);
}

// The term 0*abs(y) hides the polynomial from System.
TEST(Flow, OfAFormulaAgreesWithTheFlowOfItsPolynomial) {
  const problem::WallParameters wall{.left = 0, .left_restitution = 0.8};
  const DeterministicFlow polynomial(problem::System(
      {.damping = 0.1, .van_der_pol = 0.3, .rayleigh = 0.2, .stiffness = 1, .cubic = 0.5}, wall));
  const DeterministicFlow formula(
      problem::System({.force = "v*(0.1 + 0.3*y^2 + 0.2*v^2) + y + 0.5*y^3 + 0*abs(y)"}, wall));
  const PhaseState at{0.7, -0.4};
  EXPECT_NEAR(formula.acceleration(at), polynomial.acceleration(at), 1e-14);
  EXPECT_NEAR(formula.contraction_rate(at), polynomial.contraction_rate(at), 1e-14);
  EXPECT_NEAR(formula.mechanical_energy(at), polynomial.mechanical_energy(at), 1e-14);
  const HalfCycle expected = polynomial.half_cycle(1.3), found = formula.half_cycle(1.3);
  EXPECT_NEAR(found.impact_speed, expected.impact_speed, 1e-5);
  EXPECT_NEAR(found.duration, expected.duration, 1e-5);
}

// Dry friction 0.5, smoothed over |v| < 1e-3: the energy lost is 0.5 times the path.
TEST(Flow, ResolvesASharpChangeOfTheForce) {
  const DeterministicFlow flow(problem::System({.force = "0.5*tanh(1000*v) + y"}, {.none = true}));
  PhaseState state{1, 0.2};
  double work = 0, time = 0;
  const double start = flow.mechanical_energy(state);
  while (time < 1) {
    const double span = flow.max_time_step(state, flow.accessible_displacements(state));
    const PhaseState end = flow.advance_state(state, span);
    work += 0.5 * std::abs(end.y - state.y);  // dry friction 0.5
    state = end;
    time += span;
  }
  EXPECT_NEAR(start - flow.mechanical_energy(state), work, 2e-3 * work);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
