#include <gtest/gtest.h>

#include "backward/residual/density_error_estimator.hpp"
#include "base/input_error.hpp"
#include "uniform_edges.hpp"

namespace fpkcheck::backward {
namespace {

TEST(SplineShares, SumToOneWhereTheCellsCoverTheSplines) {
  const numerics::QuinticBSplines splines(numerics::graded_knots(-3, 3, 2, 12, 3));
  for (const auto& edges : {tests::uniform_edges(-3, 3, 7), tests::uniform_edges(-4, 5, 100)}) {
    const Eigen::RowVectorXd sums =
        spline_integral_fractions_in_cells(splines, edges).colwise().sum();
    EXPECT_LT((sums.array() - 1).abs().maxCoeff(), 1e-14);
  }
}

TEST(SplineShares, OfPolynomialsAreTheirIntegrals) {
  // Fractions times c_i int B_i sum to the integral over the cell of the spline with coefficients
  // c.
  const numerics::QuinticBSplines splines(numerics::graded_knots(0, 3, 2, 9));
  const std::vector<double> edges{-1, 0.4, 0.45, 1.9, 2.5};
  const Eigen::MatrixXd fractions = spline_integral_fractions_in_cells(splines, edges);
  const auto cube = splines.coefficients_of_monomial(3);
  Eigen::VectorXd integrals(splines.size());
  for (int i = 0; i < splines.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    integrals(i) = cube[k] * (splines.knots()[k + 6] - splines.knots()[k]) / 6;
  }
  const Eigen::VectorXd in_cells = fractions * integrals;
  for (Eigen::Index cell = 0; cell < 4; ++cell) {
    const auto at = static_cast<std::size_t>(cell);
    const double a = std::max(0.0, edges[at]), b = edges[at + 1];
    EXPECT_NEAR(in_cells(cell), (b * b * b * b - a * a * a * a) / 4, 1e-13) << cell;
  }
}

TEST(SplineShares, RejectEdgesThatDoNotIncrease) {
  const numerics::QuinticBSplines splines(numerics::graded_knots(0, 3, 2, 9));
  EXPECT_THROW(spline_integral_fractions_in_cells(splines, std::vector<double>{0, 1, 1}),
               InputError);
  EXPECT_THROW(spline_integral_fractions_in_cells(splines, std::vector<double>{0}), InputError);
}

}  // namespace
}  // namespace fpkcheck::backward
