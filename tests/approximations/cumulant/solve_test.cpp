#include "approximations/cumulant/solve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/input_error.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "exact/linear_problem.hpp"
#include "general_oscillators.hpp"
#include "laws.hpp"
#include "paper_cases.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::cumulant {
namespace {

using problem::ImpactCondition;
using problem::Problem;
using problem::System;
using transform::Status;

constexpr double kRounding = 1e-10;
const problem::WallParameters kNoWall{.none = true};

transform::Solution solve(const Problem& problem, const CumulantOptions& options = {}) {
  return solve_moment_equations(tests::in_wall_coordinates(problem), options);
}

// The standardised cumulant kappa_{p,q} among the metrics of a solution.
double cumulant_metric(const transform::Solution& solution, int p, int q) {
  for (int k = 0;; ++k) {
    const std::string path = "standardised_cumulants[" + std::to_string(k) + "].";
    const auto y = transform::metric_number(solution.metrics, path + "y");
    if (!y) break;
    if (*y == p && transform::metric_number(solution.metrics, path + "v") == q) {
      return *transform::metric_number(solution.metrics, path + "value");
    }
  }
  ADD_FAILURE() << "no cumulant " << p << ", " << q;
  return 0;
}

// Compares all cumulants up to the order 6 with Campbell's theorem.
void expect_linear_cumulants(const Problem& problem, bool only_even_orders) {
  const auto solution = solve(problem, {.order = 6});
  ASSERT_TRUE(solution.density) << solution.reason;
  EXPECT_NEAR(solution.mass, 1, kRounding);
  const auto exact = [&](int p, int q) { return exact::linear_cumulant(problem, p, q); };
  const double var_y = exact(2, 0), var_v = exact(0, 2);
  EXPECT_NEAR(solution.moments.v2 / var_v, 1, kRounding);
  if (!only_even_orders) {
    const double mean = exact(1, 0);
    EXPECT_NEAR(solution.moments.y1, mean, kRounding);
    EXPECT_NEAR(solution.moments.y2 / (var_y + mean * mean), 1, kRounding);
    const double y4 = exact(4, 0) + 4 * exact(3, 0) * mean + 3 * var_y * var_y +
                      6 * var_y * mean * mean + std::pow(mean, 4);
    EXPECT_NEAR(solution.moments.y4 / y4, 1, kRounding);
  }
  for (int order = 3; order <= 6; ++order) {
    if (only_even_orders && order % 2 == 1) continue;
    for (int p = 0; p <= order; ++p) {
      const int q = order - p;
      if (q == 1) continue;
      const double expected = exact(p, q) / (std::pow(var_y, p / 2.0) * std::pow(var_v, q / 2.0));
      const double scale = std::max(1.0, std::abs(expected));
      EXPECT_NEAR(cumulant_metric(solution, p, q), expected, kRounding * scale) << p << ' ' << q;
    }
  }
}

TEST(Cumulant, IsExactForALinearOscillatorUnderImpulsesOfAnyLaw) {
  const System system({.damping = 0.3, .stiffness = 2}, kNoWall);
  for (const auto& law : tests::law_names_without_table()) {
    SCOPED_TRACE(law);
    const problem::ImpulseTrain impulses(
        {.arrival_rate = 1.5, .law = law, .intensity = 0.4, .mean = 0.2});
    expect_linear_cumulants(tests::with_impulses(system, impulses), false);
  }
  for (const char* table : {tests::kAtoms, tests::kDensity}) {
    SCOPED_TRACE(table);
    const problem::ImpulseTrain impulses(
        {.arrival_rate = 1.5, .law = "tabulated", .intensity = 0.4, .mean = -0.1, .table = table});
    expect_linear_cumulants(tests::with_impulses(system, impulses), false);
  }
}

TEST(Cumulant, IsExactForALinearOscillatorAtAnElasticWall) {
  for (const char* law : tests::kSymmetricLaws) {
    SCOPED_TRACE(law);
    expect_linear_cumulants(tests::linear_problem({.rate = 0.7, .law = law}), true);
  }
}

TEST(Cumulant, IsGaussianUnderWhiteNoise) {
  const auto solution = solve(
      tests::with_noise(System({.damping = 0.2, .stiffness = 2}, kNoWall), 0.4), {.order = 6});
  EXPECT_EQ(solution.status, Status::ok) << solution.reason;
  EXPECT_NEAR(solution.moments.y2, 0.5, kRounding);
  EXPECT_NEAR(solution.moments.v4, 3, kRounding);
  EXPECT_NEAR(cumulant_metric(solution, 6, 0), 0, kRounding);
  const auto& density = std::get<transform::SmoothDensity>(*solution.density);
  EXPECT_NEAR(density.value(0.3, -0.4),
              std::exp(-0.3 * 0.3 / 1 - 0.4 * 0.4 / 2) / (2 * std::numbers::pi * std::sqrt(0.5)),
              kRounding);
}

// Errors of E[y^2] and E[y^4] for the Duffing oscillator decrease with the order.
TEST(Cumulant, ConvergesToTheMomentsOfTheDuffingOscillator) {
  const auto problem =
      tests::with_noise(System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, kNoWall), 0.4);
  const exact::EnergyLaw exact(problem);
  const double y2 = exact.moment(2, 0), y4 = exact.moment(4, 0);
  double error_y2 = 0.12, error_y4 = 0.4;
  for (const int order : {2, 4, 6}) {
    const auto moments = solve(problem, {.order = order}).moments;
    EXPECT_LT(std::abs(moments.y2 / y2 - 1), 0.5 * error_y2) << order;
    EXPECT_LT(std::abs(moments.y4 / y4 - 1), 0.5 * error_y4) << order;
    error_y2 = std::abs(moments.y2 / y2 - 1);
    error_y4 = std::abs(moments.y4 / y4 - 1);
    EXPECT_NEAR(moments.v2, exact.moment(0, 2), kRounding);
    EXPECT_NEAR(moments.v4, exact.moment(0, 4), kRounding);
  }
}

// With a constant term of the restoring force, E[y^2] + E[y a] contains a mean of odd order.
TEST(Cumulant, ConvergesForAConstantForceOnAnElasticWall) {
  const auto problem = tests::with_noise(
      System({.damping = 0.2, .constant = 0.2, .stiffness = 1, .restitution = 1}), 0.4);
  const exact::EnergyLaw exact(problem);
  double error = 0.04;
  for (const int order : {2, 4}) {
    const auto moments = solve(problem, {.order = order}).moments;
    EXPECT_LT(std::abs(moments.y2 / exact.moment(2, 0) - 1), 0.5 * error) << order;
    error = std::abs(moments.y2 / exact.moment(2, 0) - 1);
    EXPECT_NEAR(moments.v2, 1, kRounding);
  }
}

TEST(Cumulant, BalancesTheVirialOfAConstantForce) {
  const auto moments =
      solve(tests::with_noise(System({.damping = 0.2, .constant = 1, .restitution = 1}), 0.4),
            {.order = 2})
          .moments;
  EXPECT_NEAR(moments.v2, std::sqrt(moments.y2 * 2 / std::numbers::pi), kRounding);
}

TEST(Cumulant, OfOrderTwoWithTheImpactDeltaIsThePapersEquivalentLinearisation) {
  for (const double restitution : {0.98, 0.5}) {
    const auto problem = tests::make_problem({.cubic = 1, .restitution = restitution});
    const auto exact = problem::equivalent_linearisation(problem);
    const auto moments = solve(problem, {.order = 2, .impact = ImpactCondition::delta}).moments;
    EXPECT_NEAR(moments.y2, std::pow(exact.displacement_deviation, 2), kRounding);
    EXPECT_NEAR(moments.v2, std::pow(exact.velocity_deviation, 2), kRounding);
  }
}

// At order 2, int |u|^3 p_z(0, u) du = 2 s_v^3 / (pi s_y).
TEST(Cumulant, LosesTheEnergyOfImpacts) {
  const double c = 0.1, r = 0.6, intensity = 0.1;
  const auto moments =
      solve(tests::make_problem({.damping = c, .restitution = r, .intensity = intensity}),
            {.order = 2})
          .moments;
  const double flux = 2 * std::pow(moments.v2, 1.5) / (std::numbers::pi * std::sqrt(moments.y2));
  EXPECT_NEAR(2 * c * moments.v2 + 2 * (1 - r * r) / (1 + r * r) * flux, intensity, kRounding);
}

// Impact speeds are below 3, where the restitution coefficient of the formula is above 0.897.
TEST(Cumulant, UsesRestitutionAtTheImpactSpeed) {
  const auto mean_square_at = [](const base::NumberOrFormula& restitution) {
    return solve(tests::with_noise(System({.damping = 0.1, .stiffness = 1},
                                          {.left = 0, .left_restitution = restitution}),
                                   0.2))
        .moments.y2;
  };
  const double of_speed = mean_square_at(std::string("0.9 - 0.1*min(1, v/100)"));
  EXPECT_LT(of_speed, mean_square_at(0.9) - 1e-3);
  EXPECT_GT(of_speed, mean_square_at(0.897));
}

// The moment equations of a linear oscillator under impulses b(y) Y with a linear factor b are
// closed: 2 c k E[y^2] = intensity E[b^2].
TEST(Cumulant, IsExactForParametricImpulses) {
  const double c = 0.3, k = 2, intensity = 0.4, slope = 0.5;
  Problem problem = tests::with_impulses(System({.damping = c, .stiffness = k}, kNoWall),
                                         tests::gaussian_impulses(1.5, intensity));
  problem.impulse_factor =
      problem::StateFunction(problem::Expression::parse("1 + 0.5*y", {}, "impulse.factor", "y"));
  const double y2 = intensity / (2 * c * k - intensity * slope * slope);
  for (const int order : {2, 4, 6}) {
    const auto moments = solve(problem, {.order = order}).moments;
    EXPECT_NEAR(moments.y2, y2, kRounding) << order;
    EXPECT_NEAR(moments.v2, k * y2, kRounding) << order;
  }
}

// E[y^2] = 0.6 for the density (1 + H/2) exp(-2H), whose noise factor is no polynomial.
TEST(Cumulant, ConvergesUnderNoiseWithAFactor) {
  Problem problem =
      tests::with_noise(System({.force = "0.1*v*(1 + (y^2 + v^2)/2) + y"}, kNoWall), 0.2);
  problem.noise_factor = problem::NoiseFactor("sqrt(1 + 0.25*(y^2 + v^2))", {});
  double error = 0.12;
  for (const int order : {2, 4, 6}) {
    const auto moments = solve(problem, {.order = order}).moments;
    EXPECT_LT(std::abs(moments.y2 - 0.6), 0.5 * error) << order;
    error = std::abs(moments.y2 - 0.6);
  }
}

TEST(Cumulant, StatesANegativeDensity) {
  const auto solution = solve(
      tests::with_noise(System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, kNoWall), 0.4));
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_LT(solution.min_density, -1e-4);
  EXPECT_NE(solution.reason.find("negative"), std::string::npos);
  EXPECT_TRUE(solution.density);
}

Problem double_well_under_rare_impulses(double cubic) {
  return tests::with_impulses(
      System({.damping = 0.2, .constant = 0.1, .stiffness = -1, .cubic = cubic}, kNoWall),
      tests::gaussian_impulses(0.02, 0.1));
}

// Newton's method alone finds no solution of order 6. c E[v^2] is the power of the impulses.
TEST(Cumulant, FindsASolutionByContinuation) {
  const auto solution = solve(double_well_under_rare_impulses(10), {.order = 6});
  ASSERT_TRUE(solution.density) << solution.reason;
  EXPECT_NEAR(solution.moments.v2, 0.25, kRounding);
  EXPECT_GT(transform::metric_number(solution.metrics, "newton_steps"), 100);
}

TEST(Cumulant, StatesThatASolutionIsMissing) {
  const auto solution = solve(double_well_under_rare_impulses(1), {.order = 6});
  EXPECT_EQ(solution.status, Status::not_converged);
  EXPECT_FALSE(solution.density);
  EXPECT_NE(solution.reason.find("order 4"), std::string::npos) << solution.reason;
}

TEST(Cumulant, SupportsOneWallAndPolynomials) {
  const problem::WallParameters walls{
      .left = -1, .left_restitution = 0.9, .right = 1, .right_restitution = 0.9};
  const auto reason = [](const System& system) {
    return unsupported_reason(tests::in_wall_coordinates(tests::with_noise(system, 0.1)), {});
  };
  EXPECT_NE(reason(System({.damping = 0.1, .stiffness = 1}, walls)), "");
  EXPECT_NE(reason(System({.force = "0.1*v + y + max(y, 0)"}, kNoWall)), "");
  EXPECT_EQ(reason(System({.force = "0.1*v + y + y^5"}, kNoWall)), "");
}

TEST(Cumulant, HasTheOptionsOfItsId) {
  for (const char* id : {"cumulant-n2", "cumulant-n6", "cumulant-delta-n4"}) {
    ASSERT_TRUE(options_of(id)) << id;
    EXPECT_EQ(solution_identity(*options_of(id)).id, id);
  }
  EXPECT_FALSE(options_of("cumulant-n8"));
  EXPECT_THROW(validate({.order = 3}), InputError);
}

}  // namespace
}  // namespace fpkcheck::cumulant
