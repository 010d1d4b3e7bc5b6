#include "backward/residual/unresolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "backward/residual/judged_functions.hpp"
#include "paper_cases.hpp"
#include "residual/bell.hpp"

namespace fpkcheck::backward {
namespace {

using tests::bell;
using tests::kSv;
using tests::kSy;

WeakResiduals weak_residuals(const problem::Problem& problem) {
  auto splines = residual_splines(problem, {.y = 40, .v = 88});
  return {problem, std::move(splines.y), std::move(splines.v)};
}

ControlProblem fit_of(const problem::Problem& problem, const WeakResiduals& residuals) {
  return usual_control(problem, residuals.y(), residuals.v(), 1);
}

double one_of(double) { return 1; }
double same(double x) { return x; }
double none(double) { return 0; }

/// h = y or h = v by Marsden's identity.
Eigen::VectorXd linear(const WeakResiduals& residuals, bool in_v) {
  const auto of_v = residuals.v().power(in_v ? 1 : 0);
  const auto of_y = residuals.y().power(in_v ? 0 : 1);
  const Eigen::Map<const Eigen::VectorXd> b(of_v.data(), std::ssize(of_v)),
      a(of_y.data(), std::ssize(of_y));
  const Eigen::MatrixXd h = a * b.transpose();
  return h.reshaped<Eigen::RowMajor>();
}

TEST(Unresolved, IsNothingWhereTheBackwardEquationIsSolved) {
  // L (-y) = -v without a jump: h = -y is the exact solution for f = v, with mean 0.
  const auto problem = tests::paper_case(1);
  const auto residuals = weak_residuals(problem);
  const std::vector<SeparableFunction> f{{one_of, same}};
  const auto weak = residuals(bell());
  EXPECT_NEAR(weak.cells.sum(), 1, 1e-12);
  const Unresolved solved(fit_of(problem, residuals), f, {-linear(residuals, false), {0}});
  EXPECT_NEAR(solved.of(weak)(0), 0, 1e-12);
  // The wrong sign leaves the residual 2 v, a wrong mean leaves its error.
  const Unresolved wrong(fit_of(problem, residuals), f, {linear(residuals, false), {0}});
  EXPECT_NEAR(wrong.of(weak)(0), 2 * kSv * std::sqrt(2 / std::numbers::pi), 5e-3);
  const Unresolved off(fit_of(problem, residuals), f, {-linear(residuals, false), {0.3}});
  EXPECT_NEAR(off.of(weak)(0), 0.3, 1e-12);
}

TEST(Unresolved, CountsJumpsAtTheWallByTheirFlux) {
  // h = v jumps by (1 + r) u; its residual in the plane does not depend on r.
  const auto left = [](double restitution) {
    const auto problem = tests::make_problem({.restitution = restitution});
    const auto residuals = weak_residuals(problem);
    const Unresolved unresolved(fit_of(problem, residuals),
                                std::vector<SeparableFunction>{{none, none}},
                                {linear(residuals, true), {0}});
    return unresolved.of(residuals(bell()))(0);
  };
  const double flux = std::sqrt(std::numbers::pi / 2) * std::pow(kSv, 3) /
                      (std::numbers::pi * kSy * kSv);  // int u^2 p(0, -u) du
  EXPECT_NEAR(left(0.9) - left(0.4), 0.5 * flux, 0.01 * flux);
}

}  // namespace
}  // namespace fpkcheck::backward
