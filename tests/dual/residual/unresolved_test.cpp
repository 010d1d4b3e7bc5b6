#include "dual/residual/unresolved.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dual/residual/judged_functions.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::dual {
namespace {

constexpr double kWideY = 0.6, kWideV = 0.7;

transform::SmoothDensity half_bell() {
  return {[](double y, double v) {
            const double a = y / kWideY, b = v / kWideV;
            return std::exp(-(a * a + b * b) / 2) / (std::numbers::pi * kWideY * kWideV);
          },
          8 * kWideY, 8 * kWideV};
}

WeakResiduals weak_residuals(const problem::Problem& problem) {
  auto splines = residual_splines(problem, {.y = 40, .v = 88});
  return {problem, std::move(splines.y), std::move(splines.v)};
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
  // L (-y) = -v and no jump: the solution for f = v, of mean 0.
  const auto problem = tests::paper_case(1);
  const auto residuals = weak_residuals(problem);
  const std::vector<SeparableFunction> f{{one_of, same}};
  const auto weak = residuals(half_bell());
  EXPECT_NEAR(weak.cells.sum(), 1, 1e-12);
  const Unresolved solved(problem, residuals, f, {-linear(residuals, false), {0}});
  EXPECT_NEAR(solved.of(weak)(0), 0, 1e-12);
  // The wrong sign leaves 2 v, a wrong mean what it is off by.
  const Unresolved wrong(problem, residuals, f, {linear(residuals, false), {0}});
  EXPECT_NEAR(wrong.of(weak)(0), 2 * kWideV * std::sqrt(2 / std::numbers::pi), 5e-3);
  const Unresolved off(problem, residuals, f, {-linear(residuals, false), {0.3}});
  EXPECT_NEAR(off.of(weak)(0), 0.3, 1e-12);
}

TEST(Unresolved, CountsJumpsAtTheWallByTheirFlux) {
  // h = v jumps by (1 + r) u; in the plane it leaves the same for every r.
  const auto left = [](double restitution) {
    const auto problem = tests::make_problem({.restitution = restitution});
    const auto residuals = weak_residuals(problem);
    const Unresolved unresolved(problem, residuals, std::vector<SeparableFunction>{{none, none}},
                                {linear(residuals, true), {0}});
    return unresolved.of(residuals(half_bell()))(0);
  };
  const double flux = std::sqrt(std::numbers::pi / 2) * std::pow(kWideV, 3) /
                      (std::numbers::pi * kWideY * kWideV);  // int u^2 p(0, -u) du
  EXPECT_NEAR(left(0.9) - left(0.4), 0.5 * flux, 0.01 * flux);
}

}  // namespace
}  // namespace fpkcheck::dual
