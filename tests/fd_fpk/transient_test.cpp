#include "fd_fpk/transient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "dense_eigenvalues.hpp"
#include "exact/linear_moments.hpp"
#include "fd_fpk/operator/phase_plane_discretisation.hpp"
#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Status;

problem::Problem linear() { return tests::make_problem({.cubic = 0, .restitution = 1}); }

// An initial density wide in y' and narrow in y: its covariance rotates.
TransientOptions breathing(double until, int snapshots, double tolerance) {
  return {.until = until,
          .snapshots = snapshots,
          .start_displacement = 0.5,
          .start_velocity = 0.8,
          .relative_tolerance = tolerance};
}

// Coarse cells, for speed.
FiniteVolumeOptions coarse(DensityEquation equation) {
  return {.equation = equation, .refinement = 0.6};
}

// The largest error of E[y^2], E[y'^2] against the exact moments of the linear oscillator.
double largest_error(const problem::Problem& problem, const TransientResult& result) {
  const exact::MeanAndCovariance start{.var_z = std::pow(result.start_displacement, 2),
                                       .var_v = std::pow(result.start_velocity, 2)};
  double largest = 0;
  for (const DensitySnapshot& s : result.snapshots) {
    const auto exact = exact::linear_moments_at(problem, start, s.time);
    largest =
        std::max({largest, std::abs(s.moments.y2 - exact.zz), std::abs(s.moments.v2 - exact.vv)});
  }
  return largest;
}

TEST(Transient, HasTheExactMomentsOfTheLinearOscillatorAtAllTimes) {
  const auto problem = linear();
  for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
    SCOPED_TRACE(name(equation));
    const auto result = solve_transient(problem, coarse(equation), breathing(3, 6, 3e-8));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    ASSERT_EQ(result.snapshots.size(), 7u);
    for (int n = 0; n <= 6; ++n) EXPECT_DOUBLE_EQ(result.snapshots[n].time, 0.5 * n);
    // The moments oscillate by 0.37. The dominant error is that of the time steps, by BDF of order
    // 2.
    EXPECT_LT(largest_error(problem, result), 1e-4);
  }
}

// For accurate time steps the operator itself must be stable, without eigenvalues of positive real
// part. Operators with longer stencils have such eigenvalues, and are refused.
TEST(Transient, PermittedOrdersHaveNoGrowingModes) {
  const auto largest_real_part = [](const problem::Problem& problem, DensityEquation equation,
                                    int order) {
    const FiniteVolumeOptions options{
        .equation = equation, .order = order, .origin_refinement = 1, .nx = 16, .nv = 28};
    const auto on = discretise_density_equation(problem, options, initial_box(problem, options));
    const auto op = fokker_planck_operator(problem, options, on);
    return tests::dense_eigenvalues(op.assembled_matrix()).front().real();
  };
  constexpr double kRounding = 1e-9;
  for (const double restitution : {1.0, 0.7}) {
    const auto problem = tests::make_problem({.restitution = restitution});
    for (const int order : {3, 5}) {
      EXPECT_LT(largest_real_part(problem, DensityEquation::kf, order), kRounding) << order;
    }
    EXPECT_GT(largest_real_part(problem, DensityEquation::kf, 7), 1);
  }
}

// On uniform cells the flux is 6 % too small. The initial density is bounded at the wall and has a
// different rate.
TEST(Transient, ImpactRateUnderNoiseWithLossesTendsToTheStationaryRate) {
  const auto p = tests::make_problem({.restitution = 0.5});
  const double s = 0.3, v = 0.35;
  const auto result =
      solve_transient(p, coarse(DensityEquation::white),
                      {.until = 30, .snapshots = 2, .start_displacement = s, .start_velocity = v});
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  EXPECT_NEAR(result.snapshots.front().impact_rate, v / (std::numbers::pi * s), 1e-3);
  // WhiteNoise.ImpactRateOfAutomaticGridsIsCloseToTheLimitOfTheFlux
  EXPECT_NEAR(result.snapshots.back().impact_rate / 0.41132, 1, 1e-3);
}

TEST(Transient, ErrorsInTimeFallWithTheTolerance) {
  const auto problem = linear();
  double last = HUGE_VAL;
  for (const double tolerance : {1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto result =
        solve_transient(problem, coarse(DensityEquation::kf), breathing(2, 2, tolerance));
    const double error = largest_error(problem, result);
    EXPECT_LT(error, last / 2) << "tolerance " << tolerance;
    last = error;
  }
}

TEST(Transient, StartsWithTheRequestedGaussian) {
  const auto result =
      solve_transient(linear(), coarse(DensityEquation::kf), breathing(0.1, 1, 1e-4));
  const auto& start = result.snapshots.front();
  EXPECT_EQ(start.time, 0);
  EXPECT_NEAR(start.moments.y1, 0.5 * std::sqrt(2 / M_PI), 1e-5);
  EXPECT_NEAR(start.moments.y2, 0.25, 1e-5);
  EXPECT_NEAR(start.moments.y4, 3 * std::pow(0.5, 4), 1e-5);
  EXPECT_NEAR(start.moments.v1, 0, 1e-12);
  EXPECT_NEAR(start.moments.v2, 0.64, 1e-5);
  // p(y) is twice the normal density; its average over the first cell.
  const double edge = result.y_edges[1];
  EXPECT_NEAR(start.y.front(), std::erf(edge / 0.5 / std::sqrt(2)) / edge, 1e-6);
  EXPECT_NEAR(result.snapshots.back().time, 0.1, 1e-15);
}

TEST(Transient, KeepsMassAndTheBalanceOfPowerUnderLosses) {
  for (const double mean : {0.0, 0.15}) {
    SCOPED_TRACE(mean);
    const auto problem = tests::make_problem({.restitution = 0.9, .mean = mean});
    constexpr int kSnapshots = 40;
    constexpr double kUntil = 2;
    const auto result =
        solve_transient(problem, {.refinement = 0.8}, breathing(kUntil, kSnapshots, 1e-5));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    for (const auto& s : result.snapshots) {
      EXPECT_NEAR(s.mass, 1, 1e-10);
      EXPECT_LT(std::abs(s.power_residual), 1e-3) << s.time;
    }
    double work = 0;  // the integral of the power, by Simpson's rule
    for (int n = 0; n <= kSnapshots; ++n) {
      const double weight = n == 0 || n == kSnapshots ? 1 : n % 2 == 1 ? 4 : 2;
      work += weight * result.snapshots[n].power * kUntil / kSnapshots / 3;
    }
    EXPECT_NEAR(result.snapshots.back().energy - result.snapshots.front().energy, work, 1e-4);
  }
}

TEST(Transient, TendsToTheStationaryDensity) {
  const auto problem = tests::make_problem({.damping = 0.6, .restitution = 0.95});
  const auto transient = solve_transient(problem, coarse(DensityEquation::kf),
                                         {.until = 40, .snapshots = 1, .relative_tolerance = 1e-5});
  ASSERT_EQ(transient.status, Status::ok) << transient.reason;
  const auto stationary = solve_stationary_density(problem, coarse(DensityEquation::kf)).solution;
  const auto& end = transient.snapshots.back();
  // The grids differ because of the narrow initial density.
  EXPECT_NEAR(end.moments.y2, stationary.moments.y2, 5e-4 * stationary.moments.y2);
  EXPECT_NEAR(end.moments.v2, stationary.moments.v2, 5e-4 * stationary.moments.v2);
  EXPECT_NEAR(end.moments.v1, 0, 1e-4);
  const auto y = marginal(stationary, transform::StateVariable::y, transient.y_edges);
  EXPECT_LT(transform::l1_distance(y, {transient.y_edges, end.y, {}, {}}), 1e-3);
}

TEST(Transient, BoxContainsTheStatesAccessibleFromAWideStart) {
  // At large displacements of a hardening spring: later velocities exceed the stationary range.
  const auto problem = tests::make_problem({.cubic = 0.5, .restitution = 1});
  const auto result = solve_transient(problem, coarse(DensityEquation::white),
                                      {.until = 1,
                                       .snapshots = 4,
                                       .start_displacement = 1.0,
                                       .start_velocity = 1.0,
                                       .relative_tolerance = 1e-5});
  EXPECT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) EXPECT_LT(std::max(s.wall.x1, s.wall.x2), 1e-6);
}

TEST(Transient, ReportsABoxThatIsTooSmall) {
  const auto result = solve_transient(linear(), {.x1_max = 1.5, .x2_max = 5},
                                      {.until = 10, .snapshots = 10, .relative_tolerance = 1e-4});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_NE(result.reason.find("too small"), std::string::npos) << result.reason;
  EXPECT_LT(result.snapshots.size(), 11u);
}

TEST(Transient, DoesNotStepTheIllPosedEquation) {
  const auto result = solve_transient(
      linear(), {.equation = DensityEquation::km4, .regularisation_length = 0.0}, {.until = 1});
  EXPECT_EQ(result.status, Status::ill_posed);
  EXPECT_TRUE(result.snapshots.empty());
}

// The initial density is so narrow that a grid with cells of this width would have more than a
// million cells.
TEST(Transient, ANarrowStartDoesNotExceedTheCellLimit) {
  const auto result = solve_transient(
      linear(), {},
      {.until = 1e-4, .snapshots = 1, .start_displacement = 1e-2, .start_velocity = 1e-2});
  EXPECT_NE(result.status, Status::failed) << result.reason;
  EXPECT_FALSE(result.snapshots.empty());
}

TEST(Transient, StopsAtTheDeadline) {
  const auto result = solve_transient(linear(), {.refinement = 0.3, .max_seconds = 1e-6},
                                      {.until = 1, .snapshots = 1});
  EXPECT_EQ(result.status, Status::not_converged);
  EXPECT_EQ(result.snapshots.size(), 1u);  // the initial density
  EXPECT_NE(result.reason.find("max_seconds"), std::string::npos) << result.reason;
}

TEST(Transient, RefusesInvalidOptions) {
  EXPECT_THROW(solve_transient(linear(), {}, {.until = -1}), InputError);
  EXPECT_THROW(solve_transient(linear(), {.order = 7}, {.until = 1}), InputError);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
