#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "backward/control/control_function_fit.hpp"
#include "backward/residual/goal_functions.hpp"
#include "backward/residual/unresolved_residual.hpp"
#include "paper_cases.hpp"
#include "residual/gaussian_density.hpp"

namespace fpkcheck::backward {
namespace {

using tests::gaussian_density;
using tests::kSigmaV;
using tests::kSigmaY;

WeakResiduals weak_residuals(const problem::Problem& problem) {
  return {problem, control_splines(problem, {.y = 40, .v = 88}, CellWidths::narrower_at_walls)};
}

ControlFitProblem unit_fit(const problem::Problem& problem, const WeakResiduals& residuals) {
  return control_function_fit(problem, residuals.y(), residuals.v(), 1);
}

double constant_one(double) { return 1; }
double identity_function(double x) { return x; }
double zero_function(double) { return 0; }

/// h = y or h = v by Marsden's identity.
Eigen::VectorXd linear(const WeakResiduals& residuals, bool in_v) {
  const auto v_factor = residuals.v().coefficients_of_monomial(in_v ? 1 : 0);
  const auto y_factor = residuals.y().coefficients_of_monomial(in_v ? 0 : 1);
  const Eigen::Map<const Eigen::VectorXd> b(v_factor.data(), std::ssize(v_factor)),
      a(y_factor.data(), std::ssize(y_factor));
  const Eigen::MatrixXd h = a * b.transpose();
  return h.reshaped<Eigen::RowMajor>();
}

TEST(UnresolvedResidual, IsZeroForExactSolutions) {
  // L (-y) = -v without a jump: h = -y is the exact solution for f = v, with mean 0.
  const auto problem = tests::paper_case(1);
  const auto residuals = weak_residuals(problem);
  const std::vector<SeparableFunction> f{{constant_one, identity_function}};
  const auto weak = residuals(gaussian_density());
  EXPECT_NEAR(weak.cells.sum(), 1, 1e-12);
  const UnresolvedResidual solved(unit_fit(problem, residuals), f,
                                  {-linear(residuals, false), {0}});
  EXPECT_NEAR(solved.mean_residuals(weak)(0), 0, 1e-12);
  // With the wrong sign the residual is 2 v, with a wrong mean the residual is the error of the
  // mean.
  const UnresolvedResidual wrong(unit_fit(problem, residuals), f, {linear(residuals, false), {0}});
  EXPECT_NEAR(wrong.mean_residuals(weak)(0), 2 * kSigmaV * std::sqrt(2 / std::numbers::pi), 5e-3);
  const UnresolvedResidual off(unit_fit(problem, residuals), f, {-linear(residuals, false), {0.3}});
  EXPECT_NEAR(off.mean_residuals(weak)(0), 0.3, 1e-12);
}

TEST(UnresolvedResidual, WeightsJumpsAtTheWallByTheFlux) {
  // h = v jumps by (1 + r) u; its residual in the plane does not depend on r.
  const auto left = [](double restitution) {
    const auto problem = tests::make_problem({.restitution = restitution});
    const auto residuals = weak_residuals(problem);
    const UnresolvedResidual unresolved(
        unit_fit(problem, residuals),
        std::vector<SeparableFunction>{{zero_function, zero_function}},
        {linear(residuals, true), {0}});
    return unresolved.mean_residuals(residuals(gaussian_density()))(0);
  };
  const double flux = std::sqrt(std::numbers::pi / 2) * std::pow(kSigmaV, 3) /
                      (std::numbers::pi * kSigmaY * kSigmaV);  // int u^2 p(0, -u) du
  EXPECT_NEAR(left(0.9) - left(0.4), 0.5 * flux, 0.01 * flux);
}

}  // namespace
}  // namespace fpkcheck::backward
