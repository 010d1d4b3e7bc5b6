#include <gtest/gtest.h>

#include <limits>

#include "epc/half_plane/newton.hpp"
#include "epc/moment/equations.hpp"
#include "half_plane/galerkin_checks.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::epc::half_plane {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using tests::make_problem;

// The equations of the formulation moment of order 4, with the confinement level at six deviations.
ClosureEquations moment_equations_of_order_4(const problem::Problem& p) {
  constexpr int kOrder = 4;
  std::vector<double> rate_times_moment(kOrder + 1);
  for (int j = 1; j <= kOrder; ++j) rate_times_moment[j] = p.impulses.rate_times_moment(j);
  const double temperature = tests::temperature_of(p);
  const ExponentConfinementTerm confinement{18 * temperature};
  const moment::EnergySublevelSet domain(
      p, confinement.level * ExponentConfinementTerm::support_to_level_ratio());
  const QuadraturePoints points = domain.quadrature_points(50, 60);
  const OrthonormalBasis basis(kOrder, points, tests::boltzmann_mass(points, temperature));
  return moment::closure_equations(p, rate_times_moment, domain, confinement, basis, points, 60);
}

// The homotopy leads from the density with elastic impacts to the density at r = 0.6.
TEST(HalfPlaneNewton, TheHomotopyLeadsToTheRootThatNewtonFinds) {
  const auto p = make_problem({.restitution = 0.6});
  const ClosureEquations equations = moment_equations_of_order_4(p);
  const VectorXd start = tests::boltzmann_coefficients(equations, tests::temperature_of(p));
  const auto direct = solve_by_newton(equations, start, p.system.damping(), {.max_iterations = 60});
  ASSERT_TRUE(direct.converged);
  const auto path = follow_homotopy(equations, start);
  ASSERT_EQ(path.end, numerics::ContinuationTermination::end_reached);
  EXPECT_GT(path.points.size(), 4u);  // the path is long
  EXPECT_EQ(path.points.back().t, 1);
  const auto refined = solve_by_newton(equations, path.points.back().a, p.system.damping(), {});
  ASSERT_TRUE(refined.converged);
  EXPECT_LT((refined.a - direct.a).norm(), 1e-9);
}

TEST(HalfPlaneMetric, SizeDoesNotDependOnTheBasis) {
  VectorXd residual(3);
  residual << 0.3, -0.1, 0.2;
  MatrixXd covariance = MatrixXd::Identity(3, 3);
  covariance(0, 1) = covariance(1, 0) = 0.4;
  MatrixXd change(3, 3);  // phi' = change * phi
  change << 2, 0, 1, 0.5, 1, 0, 0, -1, 3;
  EXPECT_NEAR(residual_norm(change * residual, change * covariance * change.transpose(), 0.1),
              residual_norm(residual, covariance, 0.1), 1e-13);
  EXPECT_NEAR(residual_norm(residual, MatrixXd::Identity(3, 3), 0.1), residual.norm() / 0.1, 1e-13);
}

TEST(HalfPlaneMetric, ResidualsHaveNoSizeWhereTheMembersAreDependent) {
  MatrixXd covariance = MatrixXd::Identity(2, 2);
  covariance(0, 1) = covariance(1, 0) = 1 + 1e-12;
  EXPECT_EQ(residual_norm(VectorXd::Ones(2), covariance, 0.1),
            std::numeric_limits<double>::infinity());
}

TEST(HalfPlaneMetric, LengthIsTheDeviationOfTheChange) {
  MatrixXd covariance(2, 2);
  covariance << 4, 1, 1, 9;
  VectorXd step(2);
  step << 1, -2;
  EXPECT_NEAR(step_norm(step, covariance), std::sqrt(4 - 4 + 36.0), 1e-14);
}

TEST(HalfPlaneMetric, ConditionDoesNotDependOnTheBasis) {
  MatrixXd jacobian(2, 2), covariance = MatrixXd::Identity(2, 2);
  jacobian << 3, 1, 0, 0.5;
  MatrixXd change(2, 2);  // phi' = change * phi; a = change^T a'
  change << 2, 0, 0.5, 1;
  EXPECT_NEAR(condition_number(change * jacobian * change.transpose(),
                               change * covariance * change.transpose()),
              condition_number(jacobian, covariance), 1e-12);
}

}  // namespace
}  // namespace fpkcheck::epc::half_plane
