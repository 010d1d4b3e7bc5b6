#include "numerics/splines/bezier_extraction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fpkcheck::numerics {
namespace {

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
  const SplineBasis basis(graded_breaks(3, 7, 0.05, 1));
  for (int span = 0; span < basis.span_count(); ++span) {
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
  const SplineBasis basis(graded_breaks(3, 7, 0.05, 1));
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
