#include "approximations/path_integration/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "exact/energy_law.hpp"
#include "exact/linear_density.hpp"
#include "exact/linear_problem.hpp"
#include "general_oscillators.hpp"
#include "transform/marginal_density.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::path_integration {
namespace {

using problem::DensityEquation;
using problem::System;
using transform::StateVariable;
using transform::Status;

const problem::WallParameters kNoWall{.none = true};

transform::Solution solve_ok(const problem::Problem& problem, DensityEquation equation,
                             std::optional<int> intervals = {}) {
  auto solution = solve_by_path_integration(tests::in_wall_coordinates(problem),
                                            {.equation = equation, .intervals = intervals});
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  return solution;
}

// L1 distance of a marginal density from its exact bin averages.
double l1_error(const transform::Solution& solution, StateVariable variable,
                const std::vector<double>& edges, const std::vector<double>& exact) {
  const auto marginal = transform::marginal(*solution.density, variable, edges);
  double sum = 0;
  for (std::size_t b = 0; b < exact.size(); ++b)
    sum += std::abs(marginal.density[b] - exact[b]) * marginal.bin_width(b);
  return sum;
}

// L1 distance of the joint densities, by the rectangle rule.
double joint_l1_error(const transform::Solution& solution, const exact::EnergyLaw& law) {
  const auto& density = std::get<transform::SmoothDensity>(*solution.density);
  constexpr int kPoints = 200;
  const double dy = (density.y_max - density.y_min) / kPoints, dv = 2 * density.v_max / kPoints;
  double sum = 0;
  for (int i = 0; i < kPoints; ++i) {
    for (int j = 0; j < kPoints; ++j) {
      const double y = density.y_min + (i + 0.5) * dy, v = -density.v_max + (j + 0.5) * dv;
      sum += std::abs(density.value(y, v) - law(y, v)) * dy * dv;
    }
  }
  return sum;
}

// The extrapolated splitting is of the order 4 and the splines of the order 6.
TEST(PathIntegration, ConvergesToTheExactDensityUnderWhiteNoise) {
  const auto problem =
      tests::with_noise(System({.damping = 0.1, .stiffness = 1, .cubic = 0.5}, kNoWall), 0.4);
  const exact::EnergyLaw law(problem);
  double coarser = joint_l1_error(solve_ok(problem, DensityEquation::white, 40), law);
  for (const int intervals : {56, 80}) {
    const auto solution = solve_ok(problem, DensityEquation::white, intervals);
    const double error = joint_l1_error(solution, law);
    const double order = 2 * std::log2(coarser / error);
    EXPECT_GT(order, 3.5) << intervals;
    EXPECT_LT(order, 7) << intervals;
    EXPECT_LT(error, 2 * (solution.error->y_l1 + solution.error->ydot_l1)) << intervals;
    coarser = error;
  }
  EXPECT_LT(coarser, 5e-6);
}

TEST(PathIntegration, IsExactForElasticWalls) {
  const System systems[] = {
      System({.damping = 0.2, .constant = 1, .restitution = 1}),
      System({.damping = 0.2, .stiffness = 1},
             {.left = -0.5, .left_restitution = 1, .right = 0.7, .right_restitution = 1})};
  for (const auto& system : systems) {
    const auto problem = tests::with_noise(system, 0.4);
    const exact::EnergyLaw law(problem);
    const auto solution = solve_ok(problem, DensityEquation::kf, 64);
    constexpr double kTolerance = 1e-4;
    EXPECT_NEAR(solution.moments.y2, law.moment(2, 0), kTolerance * law.moment(2, 0));
    EXPECT_NEAR(solution.moments.v2, law.moment(0, 2), kTolerance * law.moment(0, 2));
    EXPECT_NEAR(solution.moments.v4, law.moment(0, 4), kTolerance * law.moment(0, 4));
  }
}

// Noise of the intensity 2D G(y) with the damping c G(y) has the Boltzmann density with c/D.
TEST(PathIntegration, IsExactForANoiseFactor) {
  auto problem = tests::with_noise(System({.force = "0.2*(1 + y^2)*v + y"}, kNoWall), 0.4);
  problem.noise.factor = "sqrt(1 + y^2)";
  problem.noise_factor = problem::NoiseFactor(*problem.noise.factor, {});
  const auto solution = solve_ok(problem, DensityEquation::white, 64);
  EXPECT_NEAR(solution.moments.y2, 1, 1e-4);
  EXPECT_NEAR(solution.moments.v2, 1, 1e-4);
}

TEST(PathIntegration, ConvergesToTheExactDensityUnderImpulses) {
  for (const char* law : {"gaussian", "two_point"}) {
    const auto problem = tests::linear_problem({.law = law});
    const exact::LinearDensity exact(problem);
    const auto solution = solve_ok(problem, DensityEquation::kf);
    const auto y_edges = tests::uniform_edges(0, exact.displacement_range(), 60);
    const auto v_edges = tests::uniform_edges(-exact.velocity_range(), exact.velocity_range(), 120);
    const double y =
        l1_error(solution, StateVariable::y, y_edges, exact.displacement_averages(y_edges));
    const double v =
        l1_error(solution, StateVariable::ydot, v_edges, exact.velocity_averages(v_edges));
    EXPECT_LT(y, 2 * solution.error->y_l1) << law;
    EXPECT_LT(v, 2 * solution.error->ydot_l1) << law;
    EXPECT_LT(std::max(y, v), 1e-4) << law;
  }
}

TEST(PathIntegration, BalancesThePowerOfImpacts) {
  const auto problem = tests::make_problem({.restitution = 0.9, .mean = 0.1});
  for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
    const auto solution = solve_ok(problem, equation, 64);
    EXPECT_NEAR(solution.energy_residual, 0, 2e-3);
    EXPECT_NEAR(solution.mass, 1, 1e-4);
  }
}

TEST(PathIntegration, IsInaccurateAboveTheRequiredAccuracy) {
  const auto problem = tests::in_wall_coordinates(
      tests::with_noise(System({.damping = 0.2, .stiffness = 1}, kNoWall), 0.4));
  const auto solution = solve_by_path_integration(problem, {.intervals = 32, .accuracy = 1e-12});
  EXPECT_EQ(solution.status, Status::inaccurate);
  EXPECT_NE(solution.reason.find("estimated L1 error"), std::string::npos) << solution.reason;
}

TEST(PathIntegration, RefusesProblemsWithoutADensityOrAShortTimeLaw) {
  const auto refused = [](const problem::Problem& problem) {
    return !unsupported_reason(tests::in_wall_coordinates(problem), {}).empty();
  };
  EXPECT_TRUE(
      refused(tests::with_impulses(System({.damping = 0.1, .constant = 1, .restitution = 0.9}),
                                   tests::gaussian_impulses(1, 1))));
  EXPECT_TRUE(refused(tests::with_noise(System({.force = "sign(v) + y"}, kNoWall), 1)));
  auto multiplicative = tests::with_noise(System({.force = "v + y"}, kNoWall), 1);
  EXPECT_FALSE(refused(multiplicative));
  multiplicative.noise_factor = problem::NoiseFactor("sqrt(1 + v^2)", {});
  EXPECT_TRUE(refused(multiplicative));
}

TEST(PathIntegrationOptions, FollowFromTheId) {
  for (const auto equation : {DensityEquation::white, DensityEquation::kf}) {
    const auto identity = solution_identity({.equation = equation});
    EXPECT_EQ(options_of(identity.id)->equation, equation);
  }
  EXPECT_FALSE(options_of("path"));
}

}  // namespace
}  // namespace fpkcheck::path_integration
