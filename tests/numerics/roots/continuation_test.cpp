#include "numerics/roots/continuation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::numerics {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// The homotopy g(a) - t = 0 of one unknown.
template <class Function, class Slope>
Homotopy graph(const Function& g, const Slope& slope) {
  return {[=](const VectorXd& a, double t) { return VectorXd::Constant(1, g(a[0]) - t); },
          [=](const VectorXd& a, double) { return MatrixXd::Constant(1, 1, slope(a[0])); },
          [](const VectorXd&, double) { return VectorXd::Constant(1, -1); }};
}

TEST(Continuation, PassesTwoFolds) {
  // g rises to a fold, falls, and rises again to 1.
  const auto g = [](double a) { return 4 * a * a * a - 6 * a * a + 2.6 * a; };
  const auto slope = [](double a) { return 12 * a * a - 12 * a + 2.6; };
  const Homotopy family = graph(g, slope);
  const SolutionCurve curve = trace_solution_curve(family, VectorXd::Zero(1), {});
  const auto regularity_at = [&](const SolutionCurvePoint& point) {
    return singularity_indicators(family.jacobian(point.a, point.t));
  };
  EXPECT_EQ(curve.end, ContinuationTermination::end_reached);
  ASSERT_EQ(curve.folds.size(), 2u);
  // half the distance of the roots of g'
  const double half_gap = std::sqrt(144 - 4 * 12 * 2.6) / 24;
  for (const int k : {0, 1}) {
    const SolutionCurvePoint& fold = curve.points[curve.folds[k]];
    const double expected = 0.5 + (k == 0 ? -half_gap : half_gap);
    EXPECT_NEAR(fold.a[0], expected, 1e-6);
    EXPECT_NEAR(fold.t, g(expected), 1e-10);
    EXPECT_LT(regularity_at(fold).smallest_singular_value, 1e-5);
  }
  EXPECT_EQ(curve.points.back().t, 1);
  EXPECT_NEAR(g(curve.points.back().a[0]), 1, 1e-10);
  EXPECT_EQ(curve.curve_point_with_largest_parameter().t, 1);
  for (const SolutionCurvePoint& point : curve.points) {
    EXPECT_NEAR(g(point.a[0]), point.t, 1e-10);
    const double s = slope(point.a[0]);
    if (std::abs(s) > 1e-4) {
      EXPECT_EQ(regularity_at(point).determinant_sign, s > 0 ? 1 : -1);
    }
  }
}

TEST(Continuation, ReportsReturningCurve) {
  const auto g = [](double a) { return 2 * a * (1 - a); };  // at most 1/2
  const auto slope = [](double a) { return 2 - 4 * a; };
  const SolutionCurve curve = trace_solution_curve(graph(g, slope), VectorXd::Zero(1), {});
  EXPECT_EQ(curve.end, ContinuationTermination::fell_back);
  ASSERT_EQ(curve.folds.size(), 1u);
  EXPECT_NEAR(curve.curve_point_with_largest_parameter().t, 0.5, 1e-10);
  EXPECT_NEAR(curve.points.back().a[0], 1, 1e-10);
}

TEST(Continuation, ReportsDivergence) {
  const auto g = [](double a) { return a / (1 + a); };  // g = 1 is reached only at infinity
  const auto slope = [](double a) { return 1 / ((1 + a) * (1 + a)); };
  const SolutionCurve curve = trace_solution_curve(graph(g, slope), VectorXd::Zero(1),
                                                   {.max_points = 4000, .max_norm = 20});
  EXPECT_EQ(curve.end, ContinuationTermination::diverged);
  EXPECT_TRUE(curve.folds.empty());
}

TEST(Continuation, PassesFoldsWithoutLocatingThem) {
  const auto g = [](double a) { return 4 * a * a * a - 6 * a * a + 2.6 * a; };
  const auto slope = [](double a) { return 12 * a * a - 12 * a + 2.6; };
  const SolutionCurve curve =
      trace_solution_curve(graph(g, slope), VectorXd::Zero(1), {.locate_folds = false});
  EXPECT_EQ(curve.end, ContinuationTermination::end_reached);
  EXPECT_TRUE(curve.folds.empty());
  EXPECT_NEAR(g(curve.points.back().a[0]), 1, 1e-10);
}

TEST(Continuation, ToleratesNegativeParameters) {
  // g rises to 0.06, falls to -0.39, and then rises without bound.
  const auto g = [](double a) { return 8 * a * (a * a - a + 0.16); };
  const auto slope = [](double a) { return 8 * (3 * a * a - 2 * a + 0.16); };
  const Homotopy family = graph(g, slope);
  const SolutionCurve back = trace_solution_curve(family, VectorXd::Zero(1), {});
  EXPECT_EQ(back.end, ContinuationTermination::fell_back);
  EXPECT_NEAR(back.points.back().a[0], 0.2, 1e-10);
  const SolutionCurve curve = trace_solution_curve(family, VectorXd::Zero(1), {.min_t = -1});
  EXPECT_EQ(curve.end, ContinuationTermination::end_reached);
  EXPECT_NEAR(g(curve.points.back().a[0]), 1, 1e-10);
  EXPECT_LT(std::ranges::min_element(curve.points, {}, &SolutionCurvePoint::t)->t, -0.38);
}

TEST(Continuation, AcceptsShortCorrectionsForUnscaledResiduals) {
  const auto g = [](double a) { return 1e12 * a; };
  const auto slope = [](double) { return 1e12; };
  const SolutionCurve curve =
      trace_solution_curve(graph(g, slope), VectorXd::Zero(1),
                           {.tolerance = 0, .correction_tolerance = 1e-6, .max_points = 40});
  EXPECT_EQ(curve.end, ContinuationTermination::end_reached);
}

TEST(Continuation, ReportsStepUnderflow) {
  const auto g = [](double a) { return a < 0.5 ? a : std::numeric_limits<double>::quiet_NaN(); };
  const SolutionCurve curve =
      trace_solution_curve(graph(g, [](double) { return 1.0; }), VectorXd::Zero(1), {});
  EXPECT_EQ(curve.end, ContinuationTermination::step_underflow);
  EXPECT_NEAR(curve.curve_point_with_largest_parameter().t, 0.5, 1e-3);
}

TEST(Continuation, NewtonHomotopyReachesRootPastFolds) {
  // R(a) = (a - 2)(a^2 + 1) has a maximum at 1/3 and a minimum at 1, both below 0.
  const auto residual = [](const VectorXd& a) -> VectorXd {
    return VectorXd::Constant(1, (a[0] - 2) * (a[0] * a[0] + 1));
  };
  const auto jacobian = [](const VectorXd& a) -> MatrixXd {
    return MatrixXd::Constant(1, 1, 3 * a[0] * a[0] - 4 * a[0] + 1);
  };
  const VectorXd start = VectorXd::Constant(1, -3);
  const Homotopy family = newton_homotopy(residual, jacobian, start);
  EXPECT_EQ(family.residual(start, 0)[0], 0);
  const SolutionCurve curve = trace_solution_curve(family, start, {});
  EXPECT_EQ(curve.end, ContinuationTermination::end_reached);
  EXPECT_EQ(curve.folds.size(), 2u);
  EXPECT_NEAR(curve.points.back().a[0], 2, 1e-10);
}

}  // namespace
}  // namespace fpkcheck::numerics
