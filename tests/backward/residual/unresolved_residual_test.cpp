#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "backward/control_variates/control_variate_fit.hpp"
#include "backward/residual/goal_functions.hpp"
#include "backward/residual/unresolved_residual.hpp"
#include "paper_cases.hpp"
#include "residual/gaussian_density.hpp"

namespace fpkcheck::backward {
namespace {

using tests::gaussian_density;
using tests::kSigmaV;
using tests::kSigmaY;

WeakResidualIntegrator make_case_integrator(const problem::Problem& problem) {
  return {problem, make_control_splines(problem, {.y_cells = 40, .v_cells = 88},
                                        SplineCellWidthDistribution::narrower_at_walls)};
}

ControlVariateFitProblem make_unit_fit_problem(const problem::Problem& problem,
                                               const WeakResidualIntegrator& integrator) {
  return make_control_fit_problem(problem, integrator.y_splines(), integrator.v_splines(), 1);
}

double constant_one(double) { return 1; }
double identity_function(double x) { return x; }
double zero_function(double) { return 0; }

/// Returns the coefficients of h = y or h = v, by Marsden's identity.
Eigen::VectorXd coefficients_of_coordinate(const WeakResidualIntegrator& integrator,
                                           bool is_velocity) {
  const auto v_factor = integrator.v_splines().coefficients_of_monomial(is_velocity ? 1 : 0);
  const auto y_factor = integrator.y_splines().coefficients_of_monomial(is_velocity ? 0 : 1);
  const Eigen::Map<const Eigen::VectorXd> b(v_factor.data(), std::ssize(v_factor)),
      a(y_factor.data(), std::ssize(y_factor));
  const Eigen::MatrixXd h = a * b.transpose();
  return h.reshaped<Eigen::RowMajor>();
}

TEST(UnresolvedResidual, IsZeroForExactSolutions) {
  // L (-y) = -v without a jump: h = -y is the exact solution for f = v, with mean 0.
  const auto problem = tests::paper_case(1);
  const auto integrator = make_case_integrator(problem);
  const std::vector<SeparableFunction> f{{constant_one, identity_function}};
  const auto integrals = integrator.integrate_density(gaussian_density());
  EXPECT_NEAR(integrals.cell_probabilities.sum(), 1, 1e-12);
  const BackwardEquationResiduals solved(make_unit_fit_problem(problem, integrator), f,
                                         {-coefficients_of_coordinate(integrator, false), {0}});
  EXPECT_NEAR(solved.mean_absolute_backward_residuals(integrals)(0), 0, 1e-12);
  // With the wrong sign the residual is 2 v, with a wrong mean the residual is the error of the
  // mean.
  const BackwardEquationResiduals wrong(make_unit_fit_problem(problem, integrator), f,
                                        {coefficients_of_coordinate(integrator, false), {0}});
  EXPECT_NEAR(wrong.mean_absolute_backward_residuals(integrals)(0),
              2 * kSigmaV * std::sqrt(2 / std::numbers::pi), 5e-3);
  const BackwardEquationResiduals wrong_mean(
      make_unit_fit_problem(problem, integrator), f,
      {-coefficients_of_coordinate(integrator, false), {0.3}});
  EXPECT_NEAR(wrong_mean.mean_absolute_backward_residuals(integrals)(0), 0.3, 1e-12);
}

TEST(UnresolvedResidual, WeightsJumpsAtTheWallByTheFlux) {
  // h = v jumps by (1 + r) u; its residual in the plane does not depend on r.
  const auto mean_residual = [](double restitution) {
    const auto problem = tests::make_problem({.restitution = restitution});
    const auto integrator = make_case_integrator(problem);
    const BackwardEquationResiduals unresolved(
        make_unit_fit_problem(problem, integrator),
        std::vector<SeparableFunction>{{zero_function, zero_function}},
        {coefficients_of_coordinate(integrator, true), {0}});
    return unresolved.mean_absolute_backward_residuals(
        integrator.integrate_density(gaussian_density()))(0);
  };
  const double flux = std::sqrt(std::numbers::pi / 2) * std::pow(kSigmaV, 3) /
                      (std::numbers::pi * kSigmaY * kSigmaV);  // int u^2 p(0, -u) du
  EXPECT_NEAR(mean_residual(0.9) - mean_residual(0.4), 0.5 * flux, 0.01 * flux);
}

}  // namespace
}  // namespace fpkcheck::backward
