#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>

#include "fd_fpk/solve.hpp"
#include "paper_cases.hpp"
#include "problem/exact.hpp"

namespace fpkcheck::fd_fpk {
namespace {

using transform::Variable;

// The paper's case `number` with an elastic impact: under white noise the density is exact.
problem::Problem elastic_case(int number) {
  return tests::make_problem(
      {.cubic = number <= 2 ? 0.1 : 1.0, .restitution = 1, .intensity = number % 2 ? 0.1 : 1.0});
}

// A box whose walls lie on one level of energy, `deviations` of the velocity from rest.
Options on_grid(const problem::Problem& p, int order, int nx, int nv, double deviations) {
  const double k = p.system.stiffness(), mu = p.system.cubic();
  const double v2 = problem::exact::mean_square_velocity(p) * deviations * deviations;
  return {.equation = Equation::white,
          .stepper = Stepper::direct,
          .order = order,
          .nx = nx,
          .nv = nv,
          // k x^2/2 + mu x^4/4 = v^2/2
          .x1_max = std::sqrt((std::sqrt(k * k + 2 * mu * v2) - k) / mu),
          .x2_max = std::sqrt(v2)};
}

// Integral of |bin average - exact bin average|.
double l1(const transform::Marginal& marginal, const std::function<double(double)>& exact) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  double sum = 0;
  for (std::size_t b = 0; b < marginal.size(); ++b) {
    sum += std::abs(marginal.density[b] * marginal.width(b) -
                    Rule::integrate(exact, marginal.edges[b], marginal.edges[b + 1]));
  }
  return sum;
}

struct Errors {
  double y, v;
};

Errors errors(const problem::Problem& p, const Options& options) {
  const auto solution = solve(p, options).solution;
  EXPECT_EQ(solution.status, transform::Status::ok) << solution.reason;
  if (!solution.density) return {HUGE_VAL, HUGE_VAL};
  const auto& grid = std::get<transform::GridDensity>(*solution.density);
  const problem::exact::WhiteNoiseDensity exact(p);
  return {l1(marginal(solution, Variable::y, grid.y_edges),
             [&](double y) { return exact.displacement_marginal(y); }),
          l1(marginal(solution, Variable::ydot, grid.v_edges),
             [&](double v) { return exact.velocity_marginal(v); })};
}

TEST(WhiteNoise, ElasticMarginalsAreExactToAMillionthWithOrderSeven) {
  for (const int number : {1, 2, 3, 4}) {
    const auto p = elastic_case(number);
    const auto [y, v] = errors(p, on_grid(p, 7, 40, 80, 5.5));
    EXPECT_LE(y, 1e-6) << "case " << number;
    EXPECT_LE(v, 1e-6) << "case " << number;
  }
}

TEST(WhiteNoise, AThousandCellsReachTwoHundredThousandths) {
  for (const int number : {1, 2, 3, 4}) {
    const auto p = elastic_case(number);
    const auto [y, v] = errors(p, on_grid(p, 7, 24, 48, 5.5));
    EXPECT_LE(y, 2e-5) << "case " << number;
    EXPECT_LE(v, 2e-5) << "case " << number;
  }
}

}  // namespace
}  // namespace fpkcheck::fd_fpk
