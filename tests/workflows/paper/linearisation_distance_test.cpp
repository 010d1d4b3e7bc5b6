#include "workflows/paper/linearisation_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "made_up_solutions.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::paper {
namespace {

using transform::Variable;

// Bin averages of a Gaussian: its deviation is that of equivalent linearisation times a factor.
results::Curve gaussian_curve(const problem::Problem& problem, Variable variable, double factor) {
  const auto linear = problem::equivalent_linearisation(problem);
  const bool is_y = variable == Variable::y;
  const double sigma = factor * (is_y ? linear.displacement_deviation : linear.velocity_deviation);
  const auto axes = compare::comparison_axes(problem);
  const auto& edges = compare::bin_edges(axes, variable);
  results::Curve curve{.solution = "epc-gaussian-n2",
                       .variable = variable,
                       .abscissa = {},
                       .density = {},
                       .lower = {},
                       .upper = {}};
  for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
    const double from = edges[k], to = edges[k + 1];
    const auto below = [&](double x) { return std::erf(x / (std::numbers::sqrt2 * sigma)); };
    curve.abscissa.push_back((from + to) / 2);
    curve.density.push_back((is_y ? 1.0 : 0.5) * (below(to) - below(from)) / (to - from));
  }
  return curve;
}

TEST(Linearisation, DistanceToTheSameGaussianIsZero) {
  const auto problem = tests::paper_case(4);
  for (const auto variable : transform::kVariables) {
    EXPECT_LT(l1_to_linearisation(gaussian_curve(problem, variable, 1), problem), 1e-12);
  }
}

TEST(Linearisation, DistanceToAnotherDeviationIsThatOfTwoGaussians) {
  const auto problem = tests::paper_case(1);
  // The densities cross at x^2 = 2 ln s / (1 - 1/s^2) deviations squared.
  const double s = 1.1, x = std::sqrt(2 * std::log(s) / (1 - 1 / (s * s)));
  const double l1 =
      2 * (std::erf(x / std::numbers::sqrt2) - std::erf(x / (s * std::numbers::sqrt2)));
  for (const auto variable : transform::kVariables) {
    // Up to the bins in which they cross.
    EXPECT_NEAR(l1_to_linearisation(gaussian_curve(problem, variable, s), problem), l1, 0.01 * l1);
  }
}

}  // namespace
}  // namespace fpkcheck::paper
