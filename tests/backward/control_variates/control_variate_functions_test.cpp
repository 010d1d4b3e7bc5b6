#include "backward/control_variates/control_variate_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/linear_moments.hpp"
#include "exact/linear_problem.hpp"

namespace fpkcheck::backward {
namespace {

std::function<double(double)> power_function(int n) {
  return [n](double x) { return std::pow(x, n); };
}

ControlVariateFunctions fit_on_scaled_splines(const problem::Problem& problem, int cells,
                                              double scale,
                                              const std::vector<SeparableFunction>& functions) {
  const numerics::QuinticBSplines y(numerics::graded_knots(0, 9 * scale, 5 * scale, cells));
  const numerics::QuinticBSplines v(
      numerics::graded_knots(-10 * scale, 10 * scale, 6 * scale, 2 * cells, 3));
  const auto weight = [&](double x) {
    return std::max(std::exp(-x * x / (4 * scale * scale)), 1e-9);
  };
  return fit_control_variate_functions({problem, y, v, weight, weight, 4}, functions);
}

TEST(ControlFunctions, FindTheMeansOfTheLinearOscillator) {
  // Linear oscillator with r = 1: the transformation y = |z| preserves all even moments.
  for (const char* law : tests::kSymmetricLaws) {
    const auto problem = tests::linear_problem({.law = law});
    const auto exact = exact::linear_moments_at(problem, {}, 1e4);
    const auto h = fit_on_scaled_splines(
        problem, 24, 0.7,
        {{power_function(2), power_function(0)}, {power_function(0), power_function(2)}});
    EXPECT_NEAR(h.mean_estimates[0], exact.zz, 1e-5 * exact.zz) << law;
    EXPECT_NEAR(h.mean_estimates[1], exact.vv, 1e-5 * exact.vv) << law;
  }
}

TEST(ControlFunctions, OfTheVelocityAreMinusTheDisplacement) {
  // L y = v, so that h = -y + constant, and E[v] = 0, for any problem.
  const auto problem = tests::make_problem({.restitution = 0.7, .mean = 0.1});
  const numerics::QuinticBSplines y(numerics::graded_knots(0, 6, 4, 14)),
      v(numerics::graded_knots(-7, 7, 4, 28, 3));
  const auto one = power_function(0);
  const auto h =
      fit_control_variate_functions({problem, y, v, one, one, 4}, {{one, power_function(1)}});
  EXPECT_NEAR(h.mean_estimates[0], 0, 1e-8);
  const auto y_coefficients = y.coefficients_of_monomial(1);
  const double constant = h.spline_coefficients(0, 0) + y_coefficients[0];
  for (int i = 0; i < y.size(); ++i) {
    for (int j = 0; j < v.size(); ++j) {
      EXPECT_NEAR(h.spline_coefficients(i * v.size() + j, 0), constant - y_coefficients[i],
                  1e-3);  // ridge error
    }
  }
}

TEST(ControlFunctions, ConvergeToTheReferenceValue) {
  // Case 1: E[y^2] = 0.3945181772. The coarse grid must also be less accurate than the fine grid.
  const auto problem = tests::paper_case(1);
  const auto error = [&](int cells) {
    return std::abs(
        fit_on_scaled_splines(problem, cells, 0.65, {{power_function(2), power_function(0)}})
            .mean_estimates[0] -
        0.3945181772);
  };
  const double coarse = error(12), fine = error(24);
  EXPECT_LT(fine, 1e-6);
  EXPECT_GT(coarse, 3 * fine);
  EXPECT_LT(coarse, 1e-3);
}

}  // namespace
}  // namespace fpkcheck::backward
