#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "closures.hpp"
#include "epc/closed_form_density.hpp"
#include "epc/gaussian/projected_equations.hpp"
#include "epc/selection_policy.hpp"
#include "epc/solve.hpp"
#include "exact/closed_forms.hpp"
#include "exact/energy_law.hpp"
#include "general_oscillators.hpp"

// The paper's closure without a wall: the plane is (y, y') without folding.
namespace fpkcheck::epc::gaussian {
namespace {

using problem::System;
using transform::Status;

ClosureResult solve_gaussian(const problem::Problem& problem, int order) {
  return solve_closure(problem, tests::closure_options(Formulation::gaussian, order));
}

// Duffing oscillator, bistable oscillator, and an asymmetric force, which needs all monomials.
TEST(GaussianClosureWithoutWall, IsExactForWhiteNoiseFromOrderFourOn) {
  const struct {
    System system;
    double intensity;
  } cases[] = {
      {System({.damping = 0.2, .stiffness = 1, .cubic = 0.5}, {.none = true}), 0.4},
      {System({.damping = 0.2, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1},
      {System({.damping = 0.2, .constant = 0.1, .stiffness = 1, .quadratic = 0.3, .cubic = 0.5},
              {.none = true}),
       0.4}};
  for (const auto& [system, intensity] : cases) {
    const auto p = tests::with_noise(system, intensity);
    const exact::EnergyLaw law(p);
    const auto [solution, summary] = solve_gaussian(p, 4);
    ASSERT_EQ(solution.status, Status::ok)
        << non_default_parameters_text(p) << ": " << solution.reason;
    EXPECT_NEAR(solution.moments.y1, law.moment(1, 0), 1e-9) << non_default_parameters_text(p);
    EXPECT_NEAR(solution.moments.y2, law.moment(2, 0), 1e-9) << non_default_parameters_text(p);
    EXPECT_NEAR(solution.moments.y4, law.moment(4, 0), 1e-9) << non_default_parameters_text(p);
    EXPECT_NEAR(solution.moments.v4, law.moment(0, 4), 1e-9) << non_default_parameters_text(p);
    EXPECT_NEAR(*summary.balances.virial, 0, 1e-9) << non_default_parameters_text(p);
  }
}

// y'' + (R - 1) y' + y, R = y^2 + y'^2, noise of intensity I: Q = (R - R^2/2) / I. The damping has
// the terms y^2 y' and y'^3, and both contribute to the divergence.
TEST(GaussianClosureWithoutWall, TheExactRingMeetsTheEquations) {
  const double intensity = 0.4;
  const auto p = tests::with_noise(
      System({.damping = -1, .van_der_pol = 1, .rayleigh = 1, .stiffness = 1}, {.none = true}),
      intensity);
  for (const auto set : {MonomialSet::point_symmetric, MonomialSet::general}) {
    const ProjectedEquations projection(
        GaussianWeightedBasis(4, set, gaussian_weight_deviations(p)));
    const auto f = residual_coefficients(p, problem::DensityEquation::km4);
    const Eigen::VectorXd a = projection.basis().scaled_coefficients({{2, 0, 1 / intensity},
                                                                      {0, 2, 1 / intensity},
                                                                      {4, 0, -0.5 / intensity},
                                                                      {2, 2, -1 / intensity},
                                                                      {0, 4, -0.5 / intensity}});
    EXPECT_LT(projection.residual(f, a).lpNorm<Eigen::Infinity>(), 1e-11);
    EXPECT_GT(projection.residual(f, 1.01 * a).lpNorm<Eigen::Infinity>(), 1e-3);
  }
}

TEST(GaussianClosureWithoutWall, JacobianIsTheDerivativeOfTheResidual) {
  auto p = tests::with_impulses(System({.damping = 0.1,
                                        .van_der_pol = 0.3,
                                        .rayleigh = 0.2,
                                        .constant = 0.1,
                                        .stiffness = 1,
                                        .quadratic = 0.2,
                                        .cubic = 0.4},
                                       {.none = true}),
                                tests::gaussian_impulses(1, 0.3, 0.1));
  p.noise = {0.2};
  const ProjectedEquations projection(
      GaussianWeightedBasis(4, MonomialSet::general, gaussian_weight_deviations(p)));
  const auto f = residual_coefficients(p, problem::DensityEquation::km4);
  const Eigen::VectorXd a = Eigen::VectorXd::LinSpaced(projection.basis().size(), -0.3, 0.2);
  const Eigen::MatrixXd jacobian = projection.jacobian(f, a);
  constexpr double kStep = 1e-5;
  for (Eigen::Index k = 0; k < a.size(); ++k) {
    const Eigen::VectorXd e = kStep * Eigen::VectorXd::Unit(a.size(), k);
    const Eigen::VectorXd difference =
        (projection.residual(f, a + e) - projection.residual(f, a - e)) / (2 * kStep);
    EXPECT_LT((jacobian.col(k) - difference).lpNorm<Eigen::Infinity>(),
              1e-6 * (1 + difference.lpNorm<Eigen::Infinity>()))
        << k;
  }
}

// For impulses with lambda E[Y] != 0 the response has a mean, and a third cumulant with the sign of
// E[Y^3].
TEST(GaussianClosureWithoutWall, FollowsSkewImpulses) {
  for (const double mean : {-0.1, 0.1}) {
    auto p = tests::with_impulses(
        System({.damping = 0.2, .stiffness = 1}, {.none = true}),
        problem::ImpulseTrain(
            {.arrival_rate = 1, .law = "gaussian", .intensity = 0.1, .mean = mean}));
    p.noise = {0.1};
    const auto solution = solve_gaussian(p, 6).solution;
    ASSERT_EQ(solution.status, Status::ok) << solution.reason;
    const double y1 = exact::linear_cumulant(p, 1, 0), y2 = exact::linear_cumulant(p, 2, 0);
    EXPECT_NEAR(solution.moments.y1, y1, 1e-3 * std::abs(y1));
    EXPECT_NEAR(solution.moments.y2, y2 + y1 * y1, 1e-3 * y2);
    const double third = transform::expectation(
        std::get<transform::SmoothDensity>(*solution.density),
        [&](double y, double) { return std::pow(y - solution.moments.y1, 3); });
    EXPECT_NEAR(third / exact::linear_cumulant(p, 3, 0), 1, 0.1);
  }
}

// The Gaussian in the middle of a double well satisfies the weighted equations of order 2.
TEST(GaussianClosureWithoutWall, IsInadmissibleByTheVirialBalance) {
  const auto p =
      tests::with_noise(System({.damping = 0.2, .stiffness = -1, .cubic = 1}, {.none = true}), 0.1);
  const auto [solution, summary] = solve_gaussian(p, 2);
  EXPECT_EQ(solution.status, Status::inadmissible);
  EXPECT_NE(solution.reason.find("virial"), std::string::npos) << solution.reason;
}

TEST(GaussianClosureWithoutWall, SurvivesARoundTripThroughItsClosedForm) {
  const auto p = tests::with_noise(
      System({.damping = 0.2, .constant = 0.1, .stiffness = 1, .cubic = 0.5}, {.none = true}), 0.4);
  const ClosureResult result = solve_gaussian(p, 4);
  const auto& solver_density = std::get<transform::SmoothDensity>(*result.solution.density);
  const auto again = density_of_closed_form(read_closed_form(result.solution.metrics), &p);
  EXPECT_EQ(again.y_min, solver_density.y_min);
  for (const double y : {-1.5, -0.2, 0.9}) {
    for (const double v : {-1.0, 0.4}) {
      EXPECT_NEAR(again.value(y, v) / solver_density.value(y, v), 1, 1e-12) << y << ' ' << v;
    }
  }
}

}  // namespace
}  // namespace fpkcheck::epc::gaussian
