#include <gtest/gtest.h>

#include <cmath>

#include "backward/generator/collocation.hpp"
#include "backward/generator/least_squares.hpp"
#include "problem/case_file.hpp"
#include "spline_coefficients.hpp"

namespace fpkcheck::backward {
namespace {

// Splines for case 1 with a mean amplitude. The range is so wide that jumps from near the origin do
// not reach the ends.
struct Generator {
  problem::Problem problem = problem::load_case(
      "case1",
      {"system.damping=0.3", "system.cubic=0.7", "system.restitution=0.8", "impulse.mean=0.1"});
  numerics::SplineBasis displacement{numerics::graded_breaks(2, 6, 0.1, 1)};
  ImpactBasis velocity{numerics::SplineBasis(numerics::graded_breaks(6, 9, 0.2, 2)), 0.8};
  DisplacementSplineSamples y = sample_displacement_splines(displacement, 3);
  VelocityFactorSamples v = numerics::call_with_upward_rounding([&] {
    return sample_velocity_factors(enclose_velocity_factors(problem, velocity, {}), velocity, 3);
  });

  // L (y^m v^n) at point i of y and j of v.
  double on_powers(int m, int n, std::size_t i, std::size_t j) const {
    const Eigen::VectorXd a = power_coefficients(displacement, m),
                          b = power_coefficients(velocity, n);
    const int row = static_cast<int>(j);
    const Eigen::VectorXd values = y.values[i] * a.segment(y.span[i], displacement.degree() + 1);
    return values(0) * v.jump.row(row).dot(b) + values(1) * v.drift.row(row).dot(b) +
           problem.system.restoring_force()(y.y[i]) * values(0) * v.force.row(row).dot(b);
  }
};

TEST(Generator, IsExactOnPolynomials) {
  const Generator g;
  const double c = 0.3, rate = g.problem.impulses.arrival_rate();
  const double mean = g.problem.impulses.amplitude_law().moment(1),
               square = g.problem.impulses.amplitude_law().moment(2);
  int checked = 0;
  for (std::size_t i = 0; i < g.y.y.size(); ++i) {
    for (std::size_t j = 0; j < g.v.v.size(); ++j) {
      const double y = g.y.y[i], v = g.v.v[j], force = y + 0.7 * y * y * y;
      if (std::abs(v) > 1.5) continue;
      EXPECT_NEAR(g.on_powers(0, 0, i, j), 0, 1e-10);
      EXPECT_NEAR(g.on_powers(1, 0, i, j), v, 1e-10);
      EXPECT_NEAR(g.on_powers(2, 0, i, j), 2 * y * v, 1e-10);
      EXPECT_NEAR(g.on_powers(0, 1, i, j), -c * v - force + rate * mean, 1e-10);
      EXPECT_NEAR(g.on_powers(0, 2, i, j),
                  2 * v * (-c * v - force) + rate * (2 * v * mean + square), 1e-10);
      EXPECT_NEAR(g.on_powers(1, 1, i, j), v * v + y * (-c * v - force + rate * mean), 1e-10);
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(LeastSquares, SatisfiesTheImpactConditionAndReproducesConstants) {
  const Generator g;
  const BackwardSolutions s = solve_backward_equations(
      {g.problem, g.displacement, g.velocity, g.y, g.v, [](double, double) { return 1.0; },
       [](double, double) { return 1.0; }},
      {[](double, double) { return 0.7; }, [](double y, double) { return y * y; }});
  EXPECT_NEAR(s.means[0], 0.7, 1e-9);
  EXPECT_NEAR(s.residual_extremes[0].first, 0, 1e-6);
  EXPECT_NEAR(s.residual_extremes[0].second, 0, 1e-6);
  for (int b = 0; b < g.velocity.size(); ++b) {
    EXPECT_EQ(s.coefficients[1](0, b), s.coefficients[1](0, g.velocity.mirrored_index(b)));
  }
}

}  // namespace
}  // namespace fpkcheck::backward
