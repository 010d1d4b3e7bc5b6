#include "epc/transient.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "base/input_error.hpp"
#include "epc/solve.hpp"
#include "exact/linear_moments.hpp"
#include "paper_cases.hpp"
#include "problem/case_file.hpp"

namespace fpkcheck::epc {
namespace {

using transform::Status;
using transform::TransientDensities;
using transform::TransientRequest;

problem::Problem read_problem_text(const std::string& text) {
  std::istringstream file(text);
  return problem::read_case(file, "text", "text.ini");
}

std::vector<double> uniform_edges(double from, double to, int bins) {
  std::vector<double> edges;
  for (int k = 0; k <= bins; ++k) edges.push_back(from + (to - from) * k / bins);
  return edges;
}

TransientRequest transient_request(double until, int snapshots,
                                   problem::InitialDensityOptions start = {}) {
  return {.start = start,
          .until = until,
          .snapshots = snapshots,
          .y_edges = uniform_edges(0, 5, 20),
          .v_edges = uniform_edges(-5, 5, 40)};
}

ClosureOptions closure_options(Formulation formulation, int order,
                               std::optional<DensityEquation> equation = std::nullopt) {
  return {.order = order, .formulation = formulation, .equation = equation};
}

// The density of a linear oscillator with an elastic wall at the equilibrium under white noise is
// the density of |z|, where z is Gaussian at all times, and belongs to the closure of every order.
// The covariance of (z, z') rotates, since the initial density is narrow in y.
TEST(ClosureOverTime, IsExactForALinearOscillatorAtAnElasticWallUnderWhiteNoise) {
  const auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  const double s_y = 0.6, s_v = 0.9;
  for (const auto& [formulation, order] : {std::pair{Formulation::moment, 2},
                                           {Formulation::moment, 4},
                                           {Formulation::moment, 6},
                                           {Formulation::gaussian, 2},
                                           {Formulation::gaussian, 4},
                                           {Formulation::gaussian, 6}}) {
    SCOPED_TRACE(name(formulation));
    SCOPED_TRACE(order);
    const TransientDensities result = solve_transient(
        problem, closure_options(formulation, order, DensityEquation::white),
        transient_request(6, 6, {.displacement_deviation = s_y, .velocity_deviation = s_v}));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    ASSERT_EQ(result.snapshots.size(), 7u);
    for (const auto& s : result.snapshots) {
      SCOPED_TRACE(s.time);
      const auto exact =
          exact::linear_moments_at(problem, {.var_z = s_y * s_y, .var_v = s_v * s_v}, s.time);
      EXPECT_NEAR(s.moments.y2, exact.zz, 1e-6);
      EXPECT_NEAR(s.moments.v2, exact.vv, 1e-6);
      EXPECT_NEAR(s.moments.y1, std::sqrt(2 / M_PI * exact.zz), 1e-6);
      EXPECT_NEAR(s.moments.v4, 3 * exact.vv * exact.vv, 1e-5);
      double mass = 0;
      for (std::size_t b = 0; b < s.y.size(); ++b) mass += s.y.density[b] * s.y.bin_width(b);
      EXPECT_NEAR(mass, 1, 1e-6);
    }
  }
}

// Second moments of a linear oscillator at an elastic wall at the equilibrium are exact in every
// closure whose basis contains them, under impulses and noise that change in time.
TEST(ClosureOverTime, HasTheExactSecondMomentsUnderARateThatChangesInTime) {
  auto problem = tests::make_problem({.cubic = 0, .restitution = 1});
  problem.time = problem::ExcitationTimeDependence({.rate = "1 + 0.8*sin(2*t)"}, {});
  const double s_y = 0.6, s_v = 0.9;
  for (const Formulation formulation : {Formulation::moment, Formulation::polar}) {
    const TransientDensities result = solve_transient(
        problem, closure_options(formulation, 6),
        transient_request(3, 3, {.displacement_deviation = s_y, .velocity_deviation = s_v}));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    // polar starts from the density of its form with nearly the same moments
    const double bar = formulation == Formulation::moment ? 1e-5 : 1e-3;
    for (const auto& s : result.snapshots) {
      SCOPED_TRACE(s.time);
      const auto exact =
          exact::linear_moments_in_time(problem, {.var_z = s_y * s_y, .var_v = s_v * s_v}, s.time);
      EXPECT_NEAR(s.moments.y2, exact.zz, bar);
      EXPECT_NEAR(s.moments.v2, exact.vv, bar);
    }
  }
}

// Without a wall the moment equations of a linear oscillator are closed.
TEST(ClosureOverTime, HasTheExactMomentsUnderNoiseAndAForceThatChangeInTime) {
  auto problem = read_problem_text(
      "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nnone = true\n[noise]\nintensity = 0.1\n");
  problem.time = problem::ExcitationTimeDependence(
      {.intensity = "exp(-t)", .force = "0.5*cos(1.3*t) + 0.1*t"}, {});
  for (const int order : {2, 4}) {
    const TransientDensities result = solve_transient(
        problem, closure_options(Formulation::moment, order),
        transient_request(3, 3, {.displacement_deviation = 0.6, .velocity_deviation = 0.8}));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    for (const auto& s : result.snapshots) {
      SCOPED_TRACE(s.time);
      const auto exact =
          exact::linear_moments_in_time(problem, {.var_z = 0.36, .var_v = 0.64}, s.time);
      EXPECT_NEAR(s.moments.y1, exact.z, 1e-5);
      EXPECT_NEAR(s.moments.v1, exact.v, 1e-5);
      EXPECT_NEAR(s.moments.y2, exact.zz, 1e-5);
      EXPECT_NEAR(s.moments.v2, exact.vv, 1e-5);
    }
  }
}

// Without a wall the density stays Gaussian, with a moving mean.
TEST(ClosureOverTime, OfThePaperIsExactForALinearOscillatorWithoutAWall) {
  const auto problem = read_problem_text(
      "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nnone = true\n[noise]\nintensity = 0.1\n");
  for (const int order : {2, 4}) {
    SCOPED_TRACE(order);
    const TransientDensities result =
        solve_transient(problem, closure_options(Formulation::gaussian, order),
                        transient_request(3, 3,
                                          {.displacement_deviation = 0.5,
                                           .velocity_deviation = 0.6,
                                           .mean_displacement = 0.3,
                                           .mean_velocity = -0.2}));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    for (const auto& s : result.snapshots) {
      SCOPED_TRACE(s.time);
      const auto exact = exact::linear_moments_at(
          problem, {.z = 0.3, .v = -0.2, .var_z = 0.25, .var_v = 0.36}, s.time);
      EXPECT_NEAR(s.moments.y1, exact.z, 1e-6);
      EXPECT_NEAR(s.moments.v1, exact.v, 1e-6);
      EXPECT_NEAR(s.moments.y2, exact.zz, 1e-6);
      EXPECT_NEAR(s.moments.v2, exact.vv, 1e-6);
    }
  }
}

// The projected equations of order 4 under the truncated Kramers-Moyal series have a density with a
// positive leading coefficient. A density that is wider than the weights makes them singular.
TEST(ClosureOverTime, OfThePaperStatesWhyItHasNoDensity) {
  const auto problem = tests::paper_case(1);
  const TransientDensities rising =
      solve_transient(problem, closure_options(Formulation::gaussian, 4), transient_request(6, 1));
  EXPECT_EQ(rising.status, Status::inadmissible);
  EXPECT_NE(rising.reason.find("edge of its support"), std::string::npos) << rising.reason;
  const TransientDensities wide = solve_transient(
      problem, closure_options(Formulation::gaussian, 2),
      transient_request(1, 1, {.displacement_deviation = 1.2, .velocity_deviation = 1.2}));
  EXPECT_EQ(wide.status, Status::not_converged);
  EXPECT_NE(wide.reason.find("wider than the Gaussian weights"), std::string::npos) << wide.reason;
  EXPECT_TRUE(wide.snapshots.empty());
}

TEST(ClosureOverTime, FindsThePeriodicState) {
  auto problem = read_problem_text(
      "[system]\ndamping = 0.1\nstiffness = 1\n[wall]\nnone = true\n[noise]\nintensity = 0.1\n");
  problem.time = problem::ExcitationTimeDependence(
      {.intensity = "1 + 0.9*sin(2*t)", .force = "0.1*cos(t)"}, {});
  const double period = 2 * M_PI;
  TransientRequest periodic = transient_request(period, 3);
  periodic.periodic = true;
  const TransientDensities result =
      solve_transient(problem, closure_options(Formulation::moment, 4), periodic);
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  for (const auto& s : result.snapshots) {
    SCOPED_TRACE(s.time);
    const auto exact = exact::linear_moments_in_time(problem, {}, 60 * period + s.time);
    // The moments change by at most 1e-5 standard deviations per period, of which exp(-0.3) remain.
    EXPECT_NEAR(s.moments.y1, exact.z, 1e-4);
    EXPECT_NEAR(s.moments.y2, exact.zz, 1e-4);
    EXPECT_NEAR(s.moments.v2, exact.vv, 1e-4);
  }
}

// dE/dt = lambda E[Y^2]/2 - c E[y'^2] at an elastic wall, for the exact moment equations of any
// closure whose basis contains the energy; with E[U] = k E[y^2]/2 + mu E[y^4]/4.
TEST(ClosureOverTime, SatisfiesTheBalanceOfPower) {
  const auto problem = tests::make_problem({.restitution = 1});
  const auto& system = problem.system;
  const double mu = system.restoring_force().coefficient(3);
  ASSERT_GT(mu, 0);
  const auto energy = [&](const transform::Moments& m) {
    return m.v2 / 2 + system.stiffness() * m.y2 / 2 + mu * m.y4 / 4;
  };
  const auto power = [&](const transform::Moments& m) {
    return problem.impulses.rate_times_moment(2) / 2 - system.damping() * m.v2;
  };
  for (const auto& options :
       {closure_options(Formulation::moment, 6), closure_options(Formulation::polar, 4)}) {
    SCOPED_TRACE(name(options.formulation));
    const TransientDensities result = solve_transient(problem, options, transient_request(0.4, 4));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    ASSERT_EQ(result.snapshots.size(), 5u);
    const auto& s = result.snapshots;
    // Simpson's rule for the work in two intervals
    const double h = 0.1;
    for (const std::size_t k : {1u, 3u}) {
      const double work =
          h / 3 * (power(s[k - 1].moments) + 4 * power(s[k].moments) + power(s[k + 1].moments));
      EXPECT_NEAR(energy(s[k + 1].moments) - energy(s[k - 1].moments), work, 2e-5 * h);
    }
  }
}

TEST(ClosureOverTime, RelaxesToTheStationaryClosure) {
  const auto problem = tests::paper_case(1);
  for (const auto& options :
       {closure_options(Formulation::moment, 2), closure_options(Formulation::polar, 4),
        closure_options(Formulation::gaussian, 2),
        closure_options(Formulation::gaussian, 4, DensityEquation::white)}) {
    SCOPED_TRACE(solution_id(options));
    const ClosureResult stationary = solve_closure(problem, options);
    ASSERT_EQ(stationary.solution.status, Status::ok) << stationary.solution.reason;
    const TransientDensities result = solve_transient(problem, options, transient_request(120, 12));
    ASSERT_EQ(result.status, Status::ok) << result.reason;
    EXPECT_NEAR(result.snapshots.back().moments.y2, stationary.solution.moments.y2, 2e-6);
    EXPECT_NEAR(result.snapshots.back().moments.v2, stationary.solution.moments.v2, 2e-6);
  }
}

// The slowest decay rate of the density itself is 0.1186 in case 1 (docs/theory.md).
TEST(ClosureOverTime, HasTheRelaxationRateOfTheDensity) {
  const ClosureResult result =
      solve_closure(tests::paper_case(1), closure_options(Formulation::polar, 6));
  ASSERT_TRUE(result.summary.half_plane);
  EXPECT_NEAR(result.summary.half_plane->relaxation_rate, 0.1186, 5e-4);
  EXPECT_NEAR(result.summary.half_plane->relaxation_frequency, 0, 1e-6);
}

// Values by finite volumes with a time tolerance of 1e-7 and by epc-polar-n8, which agree to 5e-5
TEST(ClosureOverTime, HasTheMomentsOfCase1) {
  const TransientDensities result = solve_transient(
      tests::paper_case(1), closure_options(Formulation::polar, 6), transient_request(6, 2));
  ASSERT_EQ(result.status, Status::ok) << result.reason;
  EXPECT_NEAR(result.snapshots[1].moments.y2, 0.18981, 2e-4);
  EXPECT_NEAR(result.snapshots[1].moments.v2, 0.20731, 2e-4);
  EXPECT_NEAR(result.snapshots[2].moments.y2, 0.25197, 1e-4);
  EXPECT_NEAR(result.snapshots[2].moments.v2, 0.27689, 1e-4);
  for (const auto& s : result.snapshots) {
    ASSERT_TRUE(s.error);
    EXPECT_GT(s.error->y_l1, 1e-4);
    EXPECT_LT(s.error->y_l1, 1e-2);
  }
}

// The order limits the accuracy. With the tolerance of the time steps of order 8 the error of order
// 10 is larger.
TEST(ClosureOverTime, ConvergesWithTheOrder) {
  const auto density_at_1 = [](int order) {
    ClosureOptions options = closure_options(Formulation::polar, order);
    options.max_seconds = 300;
    TransientRequest request = transient_request(1, 1);
    request.y_edges = uniform_edges(0, 3, 100);
    request.v_edges = uniform_edges(-4, 4, 100);
    const TransientDensities result = solve_transient(tests::paper_case(1), options, request);
    EXPECT_EQ(result.status, Status::ok) << result.reason;
    return result.snapshots.at(1);
  };
  const auto of_10 = density_at_1(10), of_12 = density_at_1(12);
  EXPECT_LT(l1_distance(of_10.y, of_12.y), 6e-4);
  EXPECT_LT(l1_distance(of_10.ydot, of_12.ydot), 6e-4);
}

// If the problem and the initial mean are mirrored, the densities in physical coordinates are
// mirrored.
TEST(ClosureOverTime, IsMirroredWithTheProblem) {
  const auto left = read_problem_text(
      "[system]\ndamping = 0.2\nstiffness = 1\n[wall]\nleft = -0.2\nleft_restitution = 0.9\n"
      "[noise]\nintensity = 0.2\n");
  const auto right = read_problem_text(
      "[system]\ndamping = 0.2\nstiffness = 1\n[wall]\nright = 0.2\nright_restitution = 0.9\n"
      "[noise]\nintensity = 0.2\n");
  TransientRequest from_left =
      transient_request(1, 1, {.mean_displacement = 0.3, .mean_velocity = 0.2});
  TransientRequest from_right =
      transient_request(1, 1, {.mean_displacement = -0.3, .mean_velocity = -0.2});
  from_left.y_edges = uniform_edges(-0.2, 4.8, 20);
  from_right.y_edges = uniform_edges(-4.8, 0.2, 20);
  const TransientDensities a =
      solve_transient(left, closure_options(Formulation::moment, 4), from_left);
  const TransientDensities b =
      solve_transient(right, closure_options(Formulation::moment, 4), from_right);
  ASSERT_EQ(a.status, Status::ok) << a.reason;
  ASSERT_EQ(b.status, Status::ok) << b.reason;
  EXPECT_NEAR(a.snapshots[1].moments.y1, -b.snapshots[1].moments.y1, 1e-9);
  EXPECT_NEAR(a.snapshots[1].moments.v1, -b.snapshots[1].moments.v1, 1e-9);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_NEAR(a.snapshots[1].y.density[k], b.snapshots[1].y.density[19 - k], 1e-7);
  }
}

TEST(ClosureOverTime, RefusesWhatNoClosureApproximates) {
  const auto problem = tests::paper_case(1);
  const auto status = [&](const ClosureOptions& options, problem::InitialDensityOptions start) {
    return solve_transient(problem, options, transient_request(1, 1, start));
  };
  const auto polar = closure_options(Formulation::polar, 4);
  EXPECT_EQ(status(polar, {.displacement_deviation = 0.1}).status, Status::not_offered);
  EXPECT_EQ(status(polar, {.velocity_deviation = 0.1}).status, Status::not_offered);
  const auto gaussian = closure_options(Formulation::gaussian, 4, DensityEquation::white);
  EXPECT_EQ(status(gaussian, {.mean_displacement = 0.5}).status, Status::not_offered);
  EXPECT_EQ(status(gaussian, {.mean_velocity = 0.5}).status, Status::not_offered);
  EXPECT_EQ(status(closure_options(Formulation::gaussian, 4, DensityEquation::kf), {}).status,
            Status::not_offered);
  auto forced = problem;
  forced.time = problem::ExcitationTimeDependence({.force = "cos(t)"}, {});
  EXPECT_EQ(solve_transient(forced, gaussian, transient_request(1, 1)).status, Status::not_offered);
  EXPECT_FALSE(status(polar, {.velocity_deviation = 0.1}).reason.empty());
  EXPECT_THROW(status(polar, {.mean_displacement = -1}), InputError);
}

TEST(ClosureOverTime, StopsAtTheTimeLimit) {
  ClosureOptions options = closure_options(Formulation::polar, 8);
  options.max_seconds = 1e-3;
  const TransientDensities result =
      solve_transient(tests::paper_case(1), options, transient_request(30, 3));
  EXPECT_EQ(result.status, Status::not_converged);
  EXPECT_LT(result.snapshots.size(), 4u);
}

}  // namespace
}  // namespace fpkcheck::epc
