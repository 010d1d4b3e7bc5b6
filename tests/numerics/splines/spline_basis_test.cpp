#include "numerics/splines/spline_basis.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::numerics {
namespace {

SplineBasis graded() { return SplineBasis(graded_break_points(3, 9, 0.02, 0.4)); }

// Coefficients of x^2 (Marsden's identity): mean of the products of two of a function's p inner
// knots.
Eigen::VectorXd square_coefficients(const SplineBasis& basis) {
  const int p = basis.degree();
  Eigen::VectorXd c = Eigen::VectorXd::Zero(basis.size());
  for (int i = 0; i < basis.size(); ++i) {
    for (int a = 1; a <= p; ++a) {
      for (int b = 1; b < a; ++b) c(i) += basis.spline_knot(i + a) * basis.spline_knot(i + b);
    }
  }
  return c * 2 / (p * (p - 1));
}

TEST(SplineBasis, IsAPartitionOfUnityThatReproducesPolynomials) {
  const SplineBasis basis = graded();
  const Eigen::VectorXd c = square_coefficients(basis);
  for (const double x : {0.0, 0.013, 0.4, 1.7, 2.99, 3.0}) {
    const int span = basis.knot_span_containing(x);
    const Eigen::MatrixXd at = basis.basis_derivatives(x, span, 3);
    const Eigen::VectorXd expected_one = Eigen::Vector4d(1, 0, 0, 0);
    EXPECT_LT((at.rowwise().sum() - expected_one).cwiseAbs().maxCoeff(), 1e-6) << x;
    EXPECT_NEAR(at.row(0).sum(), 1, 1e-14) << x;
    const Eigen::VectorXd square = at * c.segment(span, basis.degree() + 1);
    EXPECT_NEAR(square(0), x * x, 1e-13) << x;
    EXPECT_NEAR(square(1), 2 * x, 1e-11) << x;
    EXPECT_NEAR(square(2), 2, 1e-8) << x;
    EXPECT_GE(at.row(0).minCoeff(), -1e-15);
  }
}

TEST(SplineBasis, DerivativesAreThoseOfTheValues) {
  const SplineBasis basis = graded();
  for (int span = 0; span < basis.break_span_count(); ++span) {
    const double width = basis.breaks()[span + 1] - basis.breaks()[span];
    const double x = basis.breaks()[span] + 0.37 * width, h = 1e-3 * width;
    for (int d = 0; d < 3; ++d) {
      const Eigen::VectorXd difference = (basis.basis_derivatives(x + h, span, d).row(d) -
                                          basis.basis_derivatives(x - h, span, d).row(d)) /
                                         (2 * h);
      const Eigen::VectorXd slope = basis.basis_derivatives(x, span, d + 1).row(d + 1);
      EXPECT_LT((difference - slope).norm(), 1e-4 * slope.norm()) << span << " " << d;
    }
  }
}

TEST(SplineBasis, DerivativesUpToTheFifthAreContinuousAtBreaks) {
  const SplineBasis basis(graded_break_points(3, 9, 0.3, 0.6));
  for (int span = 1; span < basis.break_span_count(); ++span) {
    const double x = basis.breaks()[span];
    const Eigen::MatrixXd left = basis.basis_derivatives(x, span - 1, 6),
                          right = basis.basis_derivatives(x, span, 6);
    for (int d = 0; d <= 5; ++d) {
      const double scale = right.row(d).norm();
      EXPECT_LT((left.row(d).tail(6) - right.row(d).head(6)).norm(), 1e-8 * scale) << d;
      EXPECT_LT(std::abs(left(d, 0)) + std::abs(right(d, 6)), 1e-8 * scale) << d;
    }
    EXPECT_GT((left.row(6).tail(6) - right.row(6).head(6)).norm(), 1e-3 * right.row(6).norm());
  }
}

TEST(GradedBreaks, WidenInProportionNearTheOriginAndAreEvenBeyond) {
  const std::vector<double> x = graded_break_points(10, 60, 1e-3, 2);
  ASSERT_EQ(x.size(), 61u);
  EXPECT_EQ(x.front(), 0);
  EXPECT_EQ(x.back(), 10);
  for (int i = 0; i + 2 < 61; ++i) {
    EXPECT_GT(x[i + 2] - x[i + 1], 0.999 * (x[i + 1] - x[i])) << i;
  }
  EXPECT_LT(x[1], 1e-3);
  EXPECT_LT((x[60] - x[59]) / (x[55] - x[54]), 1.2);
}

double bernstein(int n, int j, double t) {
  return std::tgamma(n + 1) / std::tgamma(j + 1) / std::tgamma(n - j + 1) * std::pow(t, j) *
         std::pow(1 - t, n - j);
}

double value(const Eigen::MatrixXd& rows, int l, double t) {
  double sum = 0;
  for (int j = 0; j < rows.cols(); ++j) {
    sum += rows(l, j) * bernstein(static_cast<int>(rows.cols()) - 1, j, t);
  }
  return sum;
}

TEST(BezierExtraction, GiveTheFunctionsOnPartsOfASpanForwardsAndBackwards) {
  const SplineBasis basis(graded_break_points(3, 7, 0.05, 1));
  for (int span = 0; span < basis.break_span_count(); ++span) {
    const double a = basis.breaks()[span], b = basis.breaks()[span + 1];
    const double from = a + 0.2 * (b - a), to = a + 0.7 * (b - a);
    const Eigen::MatrixXd forwards = bezier_extraction<double>(basis, span, from, to);
    const Eigen::MatrixXd backwards = bezier_extraction<double>(basis, span, to, from);
    for (const double t : {0.0, 0.31, 1.0}) {
      const Eigen::MatrixXd at = basis.basis_derivatives(from + t * (to - from), span, 0);
      for (int l = 0; l <= basis.degree(); ++l) {
        EXPECT_NEAR(value(forwards, l, t), at(0, l), 1e-13);
        EXPECT_NEAR(value(backwards, l, 1 - t), at(0, l), 1e-13);
      }
    }
  }
}

TEST(BezierExtraction, ContinueThePolynomialBeyondTheSpan) {
  const SplineBasis basis(graded_break_points(3, 7, 0.05, 1));
  const int span = 3;
  const double a = basis.breaks()[span], b = basis.breaks()[span + 1];
  const Eigen::MatrixXd inside = bezier_extraction<double>(basis, span, a, b);
  const Eigen::MatrixXd across = bezier_extraction<double>(basis, span, a, 2 * b - a);
  for (int l = 0; l <= basis.degree(); ++l) {
    EXPECT_NEAR(value(across, l, 0.35), value(inside, l, 0.7), 1e-12);
  }
}

}  // namespace
}  // namespace fpkcheck::numerics
