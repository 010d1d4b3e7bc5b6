#include "mcs/transient.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/input_error.hpp"
#include "exact/linear_moments.hpp"
#include "general_oscillators.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::Status;
using transform::TransientRequest;

constexpr double kStartY = 0.5, kStartV = 0.8;

TransientRequest transient_request(double until, int snapshots) {
  return {.start = {.displacement_deviation = kStartY, .velocity_deviation = kStartV},
          .until = until,
          .snapshots = snapshots,
          .y_edges = {0, 0.5, 1, 2, 4},
          .v_edges = {-4, -1, 0, 1, 4}};
}

// With an elastic wall at the equilibrium of a linear oscillator y = |z|, and E[z^2], E[z'^2] have
// closed forms, for impulses of any law. At the start the density of y' is Gaussian.
TEST(SimulationOverTime, HasTheExactMomentsOfTheLinearOscillator) {
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 2e5, .seed = 3}, transient_request(4, 4));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  ASSERT_EQ(result.snapshots.size(), 5u);
  EXPECT_TRUE(result.has_standard_errors);
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_at(
        problem, {.var_z = kStartY * kStartY, .var_v = kStartV * kStartV}, s.time);
    ASSERT_TRUE(s.error);
    const auto& error = s.error->moments;
    EXPECT_NEAR(s.moments.y2, exact.zz, 4 * error.y2);
    EXPECT_NEAR(s.moments.v2, exact.vv, 4 * error.v2);
    // About 50 000 paths: the standard error of a mean square is 1.4 to 3 times mean / sqrt(paths).
    EXPECT_GT(error.v2, 1.2 * exact.vv / std::sqrt(50e3));
    EXPECT_LT(error.v2, 4 * exact.vv / std::sqrt(50e3));
  }
  const auto& start = result.snapshots.front();
  const double probability = std::erf(1 / kStartV / std::sqrt(2)) / 2;  // of 0 < y' < 1
  EXPECT_NEAR(start.ydot.density[2], probability, 4 * std::sqrt(0.25 / 50e3));
  EXPECT_LT(start.ydot.lower[2], start.ydot.density[2]);
  EXPECT_GT(start.ydot.upper[2], start.ydot.density[2]);
}

// Without a wall the moments of the linear oscillator are exact for impulses, noise and a force
// that change in time.
TEST(SimulationOverTime, HasTheExactMomentsUnderAnExcitationThatChangesInTime) {
  problem::Problem problem =
      tests::with_impulses(problem::System({.damping = 0.1, .stiffness = 1}, {.none = true}),
                           tests::gaussian_impulses(1, 0.2, 0.2));
  problem.noise.intensity = 0.1;
  problem.time = problem::ExcitationTimeDependence(
      {.rate = "1 + 0.8*sin(2*t)", .intensity = "exp(-t)", .force = "0.5*cos(1.3*t) + 0.2*t"}, {});
  TransientRequest from_centre = transient_request(4, 4);
  from_centre.start.mean_displacement = 0;
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 4e5, .seed = 4}, from_centre);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(
        problem, {.var_z = kStartY * kStartY, .var_v = kStartV * kStartV}, s.time);
    const auto& error = s.error->moments;
    EXPECT_NEAR(s.moments.y1, exact.z, 4 * error.y1);
    EXPECT_NEAR(s.moments.v1, exact.v, 4 * error.v1);
    EXPECT_NEAR(s.moments.y2, exact.zz, 4 * error.y2);
    EXPECT_NEAR(s.moments.v2, exact.vv, 4 * error.v2);
  }
}

// The test covers DuffingFlights under impulses with a time-dependent rate.
TEST(SimulationOverTime, HasTheExactMomentsAtAWallUnderARateThatChangesInTime) {
  auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  problem.time = problem::ExcitationTimeDependence({.rate = "4*exp(-t)"}, {});
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 2e5, .seed = 5}, transient_request(4, 2));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(
        problem, {.var_z = kStartY * kStartY, .var_v = kStartV * kStartV}, s.time);
    EXPECT_NEAR(s.moments.y2, exact.zz, 4 * s.error->moments.y2);
    EXPECT_NEAR(s.moments.v2, exact.vv, 4 * s.error->moments.v2);
  }
}

// Without noise during part of the time, the kicks have no finite rate next to the wall.
TEST(SimulationOverTime, HasFiniteMomentsWhereTheNoiseVanishes) {
  problem::Problem problem =
      tests::with_noise(problem::System({.damping = 0.2, .constant = 0.5, .stiffness = 1},
                                        {.left = 0, .left_restitution = 0.5}),
                        0.2);
  problem.time = problem::ExcitationTimeDependence({.intensity = "max(0, sin(t))"}, {});
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 2e4, .seed = 8}, transient_request(6, 3));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) EXPECT_TRUE(std::isfinite(s.moments.v2)) << s.time;
}

// A second simulation with half of the paths cannot resolve an error below sqrt(3) standard errors.
// With impact losses, for which the error is of first order, the stated error is 1 + sqrt(3)
// standard errors.
TEST(SimulationOverTime, StatesTheErrorByTheIntervalBetweenNoiseKicks) {
  constexpr double kPaths = 10 * 2048;
  const auto result = estimate_transient(tests::make_problem({.restitution = 0.5}),
                                         {.equation = DensityEquation::white, .time = 4 * kPaths},
                                         transient_request(4, 1));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  const auto in_standard_errors = [](const transform::TransientDensitySnapshot& at) {
    const double variance = at.moments.v4 - at.moments.v2 * at.moments.v2;
    return at.error->moments.v2 / std::sqrt(variance / kPaths);
  };
  EXPECT_NEAR(in_standard_errors(result.snapshots[0]), 1, 0.01);
  EXPECT_GT(in_standard_errors(result.snapshots[1]), 0.95 * (1 + std::sqrt(3)));
  EXPECT_LT(in_standard_errors(result.snapshots[1]), 6);
  double sampling_error = 0;  // of p(y') in L1
  const transform::Marginal& ydot = result.snapshots[1].ydot;
  for (std::size_t b = 0; b < ydot.size(); ++b) {
    const double probability = ydot.density[b] * ydot.bin_width(b);
    sampling_error += std::sqrt(2 / M_PI * probability * (1 - probability) / kPaths);
  }
  EXPECT_GT(result.snapshots[1].error->ydot_l1, 1.8 * sampling_error);
}

TEST(SimulationOverTime, FindsThePeriodicState) {
  problem::Problem problem =
      tests::with_impulses(problem::System({.damping = 0.4, .stiffness = 1}, {.none = true}),
                           tests::gaussian_impulses(1, 0.4));
  problem.time =
      problem::ExcitationTimeDependence({.rate = "1 + 0.9*sin(2*t)", .force = "0.3*cos(t)"}, {});
  const double period = 2 * M_PI;
  TransientRequest periodic = transient_request(period, 3);
  periodic.periodic = true;
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 1e6, .seed = 7}, periodic);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(problem, {}, 20 * period + s.time);
    EXPECT_NEAR(s.moments.y1, exact.z, 4 * s.error->moments.y1);
    EXPECT_NEAR(s.moments.y2, exact.zz, 4 * s.error->moments.y2);
    EXPECT_NEAR(s.moments.v2, exact.vv, 4 * s.error->moments.v2);
  }
}

// A force presses the mass on the wall and then lifts it off: bounces end, and the mass leaves the
// wall when the force changes its sign, at t = 2. The rebound from the drop of all paths is
// negligible for r = 0.2. Thereafter y = (t - 2)^2 / 2 without stiffness, damping and impulses.
TEST(SimulationOverTime, LiftsTheMassOffTheWallWhenTheForceChangesItsSign) {
  problem::Problem problem = tests::with_impulses(
      problem::System({.damping = 1e-4, .stiffness = 1e-4}, {.left = 0, .left_restitution = 0.2}),
      tests::gaussian_impulses(1e-4, 1e-8));
  problem.time =
      problem::ExcitationTimeDependence({.force = "20*sign(t - 2) - 19*max(0, sign(t - 2))"}, {});
  const TransientRequest at_rest{
      .start = {.displacement_deviation = 1e-3, .velocity_deviation = 1e-3},
      .until = 4,
      .snapshots = 4,
      .y_edges = {0, 1, 3},
      .v_edges = {-3, 0, 3}};
  const transform::TransientDensities result =
      estimate_transient(problem, {.time = 4e3, .seed = 6}, at_rest);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  EXPECT_LT(result.snapshots[1].moments.y2, 1e-8);
  EXPECT_NEAR(result.snapshots[3].moments.y1, 0.5, 0.01);
  EXPECT_NEAR(result.snapshots[4].moments.y1, 2, 0.01);
  EXPECT_NEAR(result.snapshots[4].moments.v1, 2, 0.01);
}

TEST(SimulationOverTime, GivesTheSameResultForAnyNumberOfThreads) {
  const auto problem = tests::paper_case(1);
  const auto one =
      estimate_transient(problem, {.time = 5e3, .threads = 1}, transient_request(1, 2));
  const auto three =
      estimate_transient(problem, {.time = 5e3, .threads = 3}, transient_request(1, 2));
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(one.snapshots[k].moments.y2, three.snapshots[k].moments.y2);
    EXPECT_EQ(one.snapshots[k].ydot.density, three.snapshots[k].ydot.density);
  }
}

TEST(SimulationOverTime, RefusesAMeanBehindTheWall) {
  TransientRequest behind = transient_request(1, 1);
  behind.start.mean_displacement = -0.5;
  EXPECT_THROW(estimate_transient(tests::paper_case(1), {}, behind), InputError);
}

}  // namespace
}  // namespace fpkcheck::mcs
