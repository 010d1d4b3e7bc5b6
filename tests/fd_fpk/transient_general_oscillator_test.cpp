#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "base/input_error.hpp"
#include "exact/linear_moments.hpp"
#include "fd_fpk/applicability.hpp"
#include "fd_fpk/solve.hpp"
#include "fd_fpk/transient.hpp"
#include "general_oscillators.hpp"
#include "transform/coordinate_transformation.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using problem::Problem;
using problem::System;
using problem::WallParameters;
using transform::StateVariable;
using transform::Status;

const problem::SystemCoefficients kLinear{.damping = 0.1, .stiffness = 1};

Problem without_wall() { return tests::with_noise(System(kLinear, {.none = true}), 0.1); }

// A wall behind a gap (cases/gap.ini), two walls, two wells (cases/bistable.ini).
Problem gap() {
  return tests::with_impulses(
      System(kLinear, WallParameters{.left = -0.5, .left_restitution = 0.9}),
      tests::gaussian_impulses(1, 0.1));
}
Problem two_walls(double mean = 0) {
  return tests::with_impulses(
      System(kLinear,
             {.left = -0.5, .left_restitution = 0.7, .right = 1, .right_restitution = 0.9}),
      tests::gaussian_impulses(2, 0.2, mean));
}
Problem bistable(double damping = 0.2) {
  return tests::with_noise(
      System({.damping = damping, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1);
}

TEST(TransientGeneralOscillator, HasTheExactMeansAndCovariancesOfTheLinearOscillatorWithoutAWall) {
  const Problem p = without_wall();
  const TransientOptions moving{.until = 1,
                                .snapshots = 2,
                                .start_displacement = 0.6,
                                .start_velocity = 0.8,
                                .start_mean_displacement = 0.7,
                                .start_mean_velocity = -0.3,
                                .relative_tolerance = 1e-8};
  const auto result = solve_transient(p, {.refinement = 0.8}, moving);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  ASSERT_EQ(result.snapshots.size(), 3u);
  const exact::MeanAndCovariance start{.z = 0.7, .v = -0.3, .var_z = 0.36, .var_v = 0.64};
  constexpr double kBar = 1e-5;  // for motion of amplitude 1
  for (const DensitySnapshot& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_at(p, start, s.time);
    EXPECT_NEAR(s.moments.y1, exact.z, kBar);
    EXPECT_NEAR(s.moments.v1, exact.v, kBar);
    EXPECT_NEAR(s.moments.y2, exact.zz, kBar);
    EXPECT_NEAR(s.yv, exact.zv, kBar);
    EXPECT_NEAR(s.moments.v2, exact.vv, kBar);
    EXPECT_NEAR(s.energy, (exact.vv + exact.zz) / 2, kBar);
    // The density remains Gaussian: fourth moments follow from the lower ones.
    const double var_z = exact.zz - exact.z * exact.z;
    EXPECT_NEAR(s.moments.y4,
                std::pow(exact.z, 4) + 6 * exact.z * exact.z * var_z + 3 * var_z * var_z,
                10 * kBar);
  }
}

// Impulses with a mean, noise and a force that all change in time: a wrong sign of F, a factor of
// the wrong term, or a factor at the wrong time changes the means or the covariances.
TEST(TransientGeneralOscillator, HasTheExactMomentsUnderAnExcitationThatChangesInTime) {
  Problem p =
      tests::with_impulses(System(kLinear, {.none = true}), tests::gaussian_impulses(1, 0.1, 0.1));
  p.noise.intensity = 0.1;
  p.time = problem::ExcitationTimeDependence(
      {.rate = "1 + 0.8*sin(2*t)", .intensity = "exp(-t)", .force = "0.5*cos(1.3*t) + 0.2*t"}, {});
  const TransientOptions moving{.until = 1,
                                .snapshots = 2,
                                .start_displacement = 0.8,
                                .start_velocity = 0.8,
                                .start_mean_displacement = 0.2,
                                .start_mean_velocity = -0.3,
                                .relative_tolerance = 1e-7};
  const auto result = solve_transient(p, {.refinement = 0.6}, moving);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  ASSERT_EQ(result.snapshots.size(), 3u);
  const exact::MeanAndCovariance start{.z = 0.2, .v = -0.3, .var_z = 0.64, .var_v = 0.64};
  constexpr double kBar = 1e-4;
  for (const DensitySnapshot& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(p, start, s.time);
    EXPECT_NEAR(s.moments.y1, exact.z, kBar);
    EXPECT_NEAR(s.moments.v1, exact.v, kBar);
    EXPECT_NEAR(s.moments.y2, exact.zz, kBar);
    EXPECT_NEAR(s.yv, exact.zv, kBar);
    EXPECT_NEAR(s.moments.v2, exact.vv, kBar);
    EXPECT_NEAR(s.mass, 1, 1e-6);
    EXPECT_LT(std::abs(s.power_residual), 1e-3);
  }
}

// The exact moments long after any start are those of the periodic state.
TEST(TransientGeneralOscillator, FindsThePeriodicState) {
  Problem p = tests::with_noise(System({.damping = 1, .stiffness = 4}, {.none = true}), 1);
  p.time = problem::ExcitationTimeDependence(
      {.intensity = "1 + 0.9*sin(4*t)", .force = "0.8*cos(2*t)"}, {});
  const double period = M_PI;
  const auto result = solve_transient(
      p, {.nx = 44, .nv = 44, .max_seconds = 60},
      {.until = period, .snapshots = 4, .relative_tolerance = 2e-5, .periodic = true});
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  EXPECT_GT(result.periods, 1);
  EXPECT_LT(result.change_over_period, 1e-4);
  for (const DensitySnapshot& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(p, {}, 20 * period + s.time);
    constexpr double kBar = 2e-3;
    EXPECT_NEAR(s.moments.y1, exact.z, kBar);
    EXPECT_NEAR(s.moments.v1, exact.v, kBar);
    EXPECT_NEAR(s.moments.y2, exact.zz, kBar);
    EXPECT_NEAR(s.moments.v2, exact.vv, kBar);
  }
}

TEST(TransientGeneralOscillator, RefusesAPeriodThatTheExcitationDoesNotHave) {
  Problem p = without_wall();
  p.time = problem::ExcitationTimeDependence({.force = "0.3*cos(t)"}, {});
  EXPECT_THROW(solve_transient(p, {}, {.until = 6, .snapshots = 4, .periodic = true}), InputError);
}

TEST(TransientGeneralOscillator, KeepsMassAndTheBalanceOfPowerBetweenTwoLossyWalls) {
  for (const double mean : {0.0, 0.1}) {
    SCOPED_TRACE(mean);
    constexpr int kSnapshots = 30;
    constexpr double kUntil = 1.5;
    const auto result =
        solve_transient(two_walls(mean), {},
                        {.until = kUntil, .snapshots = kSnapshots, .relative_tolerance = 1e-6});
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    double work = 0;  // the integral of the power, by Simpson's rule
    for (int n = 0; n <= kSnapshots; ++n) {
      const DensitySnapshot& s = result.snapshots[n];
      EXPECT_NEAR(s.mass, 1, 1e-10);
      EXPECT_LT(std::abs(s.power_residual), 2e-3) << s.time;
      const double weight = n == 0 || n == kSnapshots ? 1 : n % 2 == 1 ? 4 : 2;
      work += weight * s.power * kUntil / kSnapshots / 3;
    }
    EXPECT_NEAR(result.snapshots.back().energy - result.snapshots.front().energy, work, 2e-4);
    EXPECT_NEAR(result.y_edges.front(), -0.5, 1e-14);
    EXPECT_NEAR(result.y_edges.back(), 1, 1e-14);
    EXPECT_GT(result.snapshots.back().impact_rate, 0.1);
  }
}

// The factor of noise or impulses is sqrt(1 + y^2/5). The second moments m = (yy, yv, vv) of the
// linear oscillator obey the closed equations dm/dt = A m + (0, 0, I), with the intensity I = 2D or
// I = lambda E[Y^2].
TEST(TransientGeneralOscillator, HasTheExactSecondMomentsUnderParametricExcitation) {
  const System system({.damping = 0.4, .stiffness = 1}, {.none = true});
  const std::string factor = "sqrt(1 + 0.2*y^2)";
  Problem noise = tests::with_noise(system, 0.2);
  noise.noise_factor.emplace(factor, problem::NamedConstants{});
  Problem impulses = tests::with_impulses(system, tests::gaussian_impulses(4, 0.2));
  impulses.impulse_factor.emplace(problem::Expression::parse(factor, {}, "impulse.factor"));
  const TransientOptions moving{.until = 1,
                                .snapshots = 1,
                                .start_displacement = 0.4,
                                .start_velocity = 0.3,
                                .start_mean_displacement = 0.5,
                                .start_mean_velocity = 0.2,
                                .relative_tolerance = 1e-7};
  const Eigen::Matrix3d a{{0, 2, 0}, {-1, -0.4, 1}, {0.2 * 0.2, -2, -0.8}};
  const Eigen::Vector3d start{0.16 + 0.25, 0.1, 0.09 + 0.04};
  const Eigen::Vector3d limit = a.lu().solve(Eigen::Vector3d{0, 0, -0.2});
  const Eigen::EigenSolver<Eigen::Matrix3d> modes(a);
  const Eigen::Vector3cd amplitudes =
      modes.eigenvectors().lu().solve((start - limit).cast<std::complex<double>>());
  for (const Problem& p : {noise, impulses}) {
    SCOPED_TRACE(p.impulse_factor ? "impulses" : "noise");
    const auto result = solve_transient(p, {.refinement = 0.8}, moving);
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    for (const DensitySnapshot& s : result.snapshots) {
      SCOPED_TRACE(s.time);
      const Eigen::Vector3cd decayed =
          (modes.eigenvalues() * s.time).array().exp() * amplitudes.array();
      const Eigen::Vector3d exact = limit + (modes.eigenvectors() * decayed).real();
      constexpr double kBar = 1e-5;
      EXPECT_NEAR(s.moments.y2, exact(0), kBar);
      EXPECT_NEAR(s.yv, exact(1), kBar);
      EXPECT_NEAR(s.moments.v2, exact(2), kBar);
      EXPECT_LT(std::abs(s.power_residual), 1e-4);
    }
  }
}

// The term 0*tanh(y) hides the polynomial from System.
TEST(TransientGeneralOscillator, OfAFormulaIsThatOfItsPolynomial) {
  const auto snapshots_of = [](const problem::SystemCoefficients& coefficients) {
    const System system(coefficients, WallParameters{.left = -0.4, .left_restitution = 0.9});
    const auto result =
        solve_transient(tests::with_impulses(system, tests::gaussian_impulses(1, 0.2)),
                        {.nx = 40, .nv = 60, .x1_max = 3.5, .x2_max = 3.5},
                        {.until = 1,
                         .snapshots = 2,
                         .start_displacement = 0.4,
                         .start_velocity = 0.4,
                         .start_mean_displacement = 0.2,
                         .relative_tolerance = 1e-6});
    EXPECT_EQ(result.status, Status::ok) << result.reason;
    return result.snapshots;
  };
  const auto expected = snapshots_of({.damping = 0.1, .stiffness = 1, .cubic = 0.3});
  const auto snapshots = snapshots_of({.force = "0.1*v + y + 0.3*y^3 + 0*tanh(y)"});
  ASSERT_EQ(snapshots.size(), expected.size());
  for (std::size_t n = 0; n < snapshots.size(); ++n) {
    constexpr double kRounding = 1e-9;
    EXPECT_NEAR(snapshots[n].moments.y2, expected[n].moments.y2, kRounding);
    EXPECT_NEAR(snapshots[n].moments.v4, expected[n].moments.v4, kRounding);
    EXPECT_NEAR(snapshots[n].energy, expected[n].energy, kRounding);
    EXPECT_NEAR(snapshots[n].power, expected[n].power, kRounding);
    EXPECT_NEAR(snapshots[n].power_residual, expected[n].power_residual, kRounding);
  }
}

// The rate of change of the energy, from the potential of the formula, is the power.
TEST(TransientGeneralOscillator, OfAFormulaKeepsMassAndTheBalanceOfPower) {
  const System bilinear({.force = "0.3*v*abs(v) + y + 4*max(y-0.3,0)"},
                        WallParameters{.left = -0.4, .left_restitution = 0.8});
  const auto result = solve_transient(
      tests::with_impulses(bilinear, tests::gaussian_impulses(1, 0.2)), {},
      {.until = 2, .snapshots = 4, .start_mean_displacement = 0.2, .relative_tolerance = 1e-6});
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const DensitySnapshot& s : result.snapshots) {
    EXPECT_NEAR(s.mass, 1, 1e-10);
    EXPECT_LT(std::abs(s.power_residual), 2e-3) << s.time;
    EXPECT_GT(std::abs(s.power), 1e-3) << s.time;
  }
}

struct LongTimeCase {
  std::string name;
  Problem problem;
  double until;
  double bar;  // limit for the L1 distance of each marginal and the relative error of moments
};

TEST(TransientGeneralOscillator, TendsToTheStationaryDensity) {
  // More damping than in the case file: the wells exchange mass sooner.
  for (const auto& [name, p, until, bar] :
       {LongTimeCase{"gap", gap(), 60, 2e-3}, LongTimeCase{"bistable", bistable(0.5), 60, 5e-4}}) {
    SCOPED_TRACE(name);
    const auto over_time = solve_transient(
        p, {.refinement = 0.7}, {.until = until, .snapshots = 1, .relative_tolerance = 1e-4});
    ASSERT_EQ(over_time.status, Status::ok) << over_time.reason;
    const Problem seen = tests::in_wall_coordinates(p);
    const auto stationary = transform::to_physical_coordinates(
        seen.frame, solve_stationary_density(
                        seen, {.stepper = StationarySolver::direct, .error_estimate = false})
                        .solution);
    const DensitySnapshot& end = over_time.snapshots.back();
    EXPECT_NEAR(end.moments.y2, stationary.moments.y2, bar * stationary.moments.y2);
    EXPECT_NEAR(end.moments.v2, stationary.moments.v2, bar * stationary.moments.v2);
    EXPECT_NEAR(end.moments.v1, 0, bar);
    EXPECT_NEAR(end.yv, 0, bar);
    const auto far = [&](StateVariable variable, const std::vector<double>& edges,
                         const std::vector<double>& density) {
      return transform::l1_distance(marginal(stationary, variable, edges),
                                    {edges, density, {}, {}});
    };
    EXPECT_LT(far(StateVariable::y, over_time.y_edges, end.y), bar);
    EXPECT_LT(far(StateVariable::ydot, over_time.v_edges, end.v), bar);
  }
}

TEST(TransientGeneralOscillator, ErrorsFallWithTheCells) {
  const auto at = [&](double refinement) {
    const auto result = solve_transient(
        two_walls(), {.refinement = refinement},
        {.until = 1, .snapshots = 1, .start_mean_displacement = 0.5, .relative_tolerance = 1e-6});
    EXPECT_EQ(result.status, Status::ok) << result.reason;
    return result.snapshots.back().moments;
  };
  const auto coarse = at(0.5), middle = at(0.75), fine = at(1.125);
  EXPECT_LT(std::abs(middle.y2 - fine.y2), std::abs(coarse.y2 - fine.y2) / 2);
  EXPECT_LT(std::abs(middle.v2 - fine.v2), std::abs(coarse.v2 - fine.v2) / 2);
  EXPECT_NEAR(middle.v2, fine.v2, 1e-3 * fine.v2);
}

// A single wall on the right with impulses of nonzero mean, and its mirror image.
TEST(TransientGeneralOscillator, IsInPhysicalCoordinates) {
  const problem::SystemCoefficients spring{
      .damping = 0.2, .constant = 0.3, .stiffness = 1, .cubic = 0.2};
  problem::SystemCoefficients turned = spring;
  turned.constant = -spring.constant;
  const Problem right =
      tests::with_impulses(System(spring, WallParameters{.right = 0.4, .right_restitution = 0.8}),
                           tests::gaussian_impulses(2, 0.2, 0.1));
  const Problem left =
      tests::with_impulses(System(turned, WallParameters{.left = -0.4, .left_restitution = 0.8}),
                           tests::gaussian_impulses(2, 0.2, -0.1));
  const TransientOptions from_right{.until = 1,
                                    .snapshots = 2,
                                    .start_mean_displacement = -0.6,
                                    .start_mean_velocity = 0.3,
                                    .relative_tolerance = 1e-6};
  TransientOptions from_left = from_right;
  from_left.start_mean_displacement = 0.6;
  from_left.start_mean_velocity = -0.3;
  const auto a = solve_transient(right, {.refinement = 0.7}, from_right);
  const auto b = solve_transient(left, {.refinement = 0.7}, from_left);
  ASSERT_EQ(a.status, Status::ok) << a.reason;
  EXPECT_EQ(a.start_mean_displacement, -0.6);
  EXPECT_EQ(a.start_mean_velocity, 0.3);
  EXPECT_NEAR(a.y_edges.back(), 0.4, 1e-14);
  EXPECT_LT(a.y_edges.front(), -1);
  ASSERT_EQ(a.snapshots.size(), b.snapshots.size());
  // The initial density of the options, in both problems.
  EXPECT_NEAR(a.snapshots.front().moments.v1, 0.3, 1e-3);
  EXPECT_LT(a.snapshots.front().moments.y1, -0.5);
  constexpr double kRounding = 1e-9;
  for (std::size_t n = 0; n < a.snapshots.size(); ++n) {
    const DensitySnapshot &s = a.snapshots[n], &t = b.snapshots[n];
    SCOPED_TRACE(s.time);
    EXPECT_NEAR(s.moments.y1, -t.moments.y1, kRounding);
    EXPECT_NEAR(s.moments.y2, t.moments.y2, kRounding);
    EXPECT_NEAR(s.moments.v1, -t.moments.v1, kRounding);
    EXPECT_NEAR(s.yv, t.yv, kRounding);
    EXPECT_NEAR(s.energy, t.energy, kRounding);
    EXPECT_NEAR(s.energy,
                s.moments.v2 / 2 + 0.3 * s.moments.y1 + s.moments.y2 / 2 + 0.05 * s.moments.y4,
                1e-5);
    ASSERT_EQ(s.y.size() + 1, a.y_edges.size());
    double mean_y = 0, mean_v = 0;
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      EXPECT_NEAR(s.y[i], t.y[s.y.size() - 1 - i], 1e-7);
      mean_y += s.y[i] * (a.y_edges[i + 1] - a.y_edges[i]) * (a.y_edges[i] + a.y_edges[i + 1]) / 2;
    }
    for (std::size_t j = 0; j < s.v.size(); ++j) {
      mean_v += s.v[j] * (a.v_edges[j + 1] - a.v_edges[j]) * (a.v_edges[j] + a.v_edges[j + 1]) / 2;
    }
    EXPECT_NEAR(mean_y, s.moments.y1, 2e-3);  // cell centres are accurate to second order
    EXPECT_NEAR(mean_v, s.moments.v1, 2e-3);
  }
}

TEST(TransientGeneralOscillator, IsRefusedWhereTheMassComesToRest) {
  const problem::SystemCoefficients preload{.damping = 0.1, .constant = 0.5, .stiffness = 1};
  const Problem pressed =
      tests::with_impulses(System(preload, WallParameters{.left = 0, .left_restitution = 0.7}),
                           tests::gaussian_impulses(1, 0.5));
  EXPECT_THROW(solve_transient(pressed, {}, {.until = 1}), InputError);
  // Diffusion ends the contact at once.
  EXPECT_EQ(transient_unsupported_reason(pressed, {.equation = DensityEquation::white}), "");
  EXPECT_NE(transient_unsupported_reason(pressed, {.equation = DensityEquation::kf}), "");
  EXPECT_NE(transient_unsupported_reason(pressed, {.equation = DensityEquation::km4_pade}), "");
}

TEST(TransientGeneralOscillator, DoesNotStartBehindAWall) {
  EXPECT_THROW(solve_transient(gap(), {}, {.until = 1, .start_mean_displacement = -0.6}),
               InputError);
  EXPECT_THROW(solve_transient(two_walls(), {}, {.until = 1, .start_mean_displacement = 1.1}),
               InputError);
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
