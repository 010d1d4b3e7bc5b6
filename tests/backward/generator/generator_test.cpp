#include <gtest/gtest.h>

#include <cmath>

#include "backward/generator/backward_equation_fit.hpp"
#include "backward/generator/generator_at_collocation_points.hpp"
#include "problem/case_file.hpp"
#include "spline_coefficients.hpp"

namespace fpkcheck::backward {
namespace {

// Splines for case 1 with a mean amplitude. The range is so wide that jumps from near the origin do
// not reach the ends.
struct GeneratorSamples {
  problem::Problem problem = problem::load_case(
      "case1",
      {"system.damping=0.3", "system.cubic=0.7", "system.restitution=0.8", "impulse.mean=0.1"});
  numerics::SplineBasis displacement{numerics::graded_break_points(2, 6, 0.1, 1)};
  ImpactSplineBasis velocity{numerics::SplineBasis(numerics::graded_break_points(6, 9, 0.2, 2)),
                             0.8};
  DisplacementSplineSamples displacement_samples = sample_displacement_splines(displacement, 3);
  GeneratorVelocityFactorSamples velocity_samples = numerics::call_with_upward_rounding([&] {
    return sample_velocity_factors(enclose_velocity_factors(problem, velocity, {}), velocity, 3);
  });

  // Returns the value of L (y^m v^n) at the point i of y and the point j of v.
  double generator_of_monomial(int m, int n, std::size_t i, std::size_t j) const {
    const Eigen::VectorXd a = power_coefficients(displacement, m),
                          b = power_coefficients(velocity, n);
    const int row = static_cast<int>(j);
    const Eigen::VectorXd values =
        displacement_samples.values_and_slopes[i] *
        a.segment(displacement_samples.knot_spans[i], displacement.degree() + 1);
    return values(0) * velocity_samples.impulse_and_damping.row(row).dot(b) +
           values(1) * velocity_samples.transport.row(row).dot(b) +
           problem.system.restoring_force()(displacement_samples.displacements[i]) * values(0) *
               velocity_samples.restoring_force.row(row).dot(b);
  }
};

TEST(Generator, IsExactOnPolynomials) {
  const GeneratorSamples g;
  const double c = 0.3, rate = g.problem.impulses.arrival_rate();
  const double mean = g.problem.impulses.amplitude_law().moment(1),
               square = g.problem.impulses.amplitude_law().moment(2);
  int checked = 0;
  for (std::size_t i = 0; i < g.displacement_samples.displacements.size(); ++i) {
    for (std::size_t j = 0; j < g.velocity_samples.velocities.size(); ++j) {
      const double y = g.displacement_samples.displacements[i],
                   v = g.velocity_samples.velocities[j], force = y + 0.7 * y * y * y;
      if (std::abs(v) > 1.5) continue;
      EXPECT_NEAR(g.generator_of_monomial(0, 0, i, j), 0, 1e-10);
      EXPECT_NEAR(g.generator_of_monomial(1, 0, i, j), v, 1e-10);
      EXPECT_NEAR(g.generator_of_monomial(2, 0, i, j), 2 * y * v, 1e-10);
      EXPECT_NEAR(g.generator_of_monomial(0, 1, i, j), -c * v - force + rate * mean, 1e-10);
      EXPECT_NEAR(g.generator_of_monomial(0, 2, i, j),
                  2 * v * (-c * v - force) + rate * (2 * v * mean + square), 1e-10);
      EXPECT_NEAR(g.generator_of_monomial(1, 1, i, j), v * v + y * (-c * v - force + rate * mean),
                  1e-10);
      ++checked;
    }
  }
  EXPECT_GT(checked, 200);
}

TEST(LeastSquares, SatisfiesTheImpactConditionAndReproducesConstants) {
  const GeneratorSamples g;
  const BackwardEquationSolutions s = fit_backward_equation_solutions(
      {g.problem, g.displacement, g.velocity, g.displacement_samples, g.velocity_samples,
       [](double, double) { return 1.0; }, [](double, double) { return 1.0; }},
      {[](double, double) { return 0.7; }, [](double y, double) { return y * y; }});
  EXPECT_NEAR(s.mean_estimates[0], 0.7, 1e-9);
  EXPECT_NEAR(s.residual_extremes[0].first, 0, 1e-6);
  EXPECT_NEAR(s.residual_extremes[0].second, 0, 1e-6);
  for (int b = 0; b < g.velocity.size(); ++b) {
    EXPECT_EQ(s.spline_coefficients[1](0, b),
              s.spline_coefficients[1](0, g.velocity.basis_index_after_impact(b)));
  }
}

}  // namespace
}  // namespace fpkcheck::backward
