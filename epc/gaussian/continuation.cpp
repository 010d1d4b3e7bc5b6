#include "epc/gaussian/continuation.hpp"

#include <cmath>
#include <numbers>

#include "epc/form/exponent_polynomial.hpp"
#include "numerics/linear_algebra/factorisations.hpp"
#include "numerics/roots/continuation.hpp"

namespace fpkcheck::epc::gaussian {
namespace {

using numerics::ContinuationTermination;
using numerics::Homotopy;
using numerics::NewtonResult;
using numerics::SolutionCurve;
using numerics::SolutionCurvePoint;

constexpr int kMaxPoints = 120;
constexpr int kPolishing = 30;  // largest number of Newton steps at the end of a curve

// Returns the absolute moment E[|x|^m] of a Gaussian variable x ~ N(0, sigma^2).
double absolute_moment(double m, double sigma) {
  return std::pow(std::numbers::sqrt2 * sigma, m) * std::tgamma((m + 1) / 2) *
         std::numbers::inv_sqrtpi;
}

// Returns the exponent -(c/D2) (x2^2/2 + U(|x1|)) of the exact density under white noise with
// elastic impacts, with the damping c and the potential U. For an even power a y^m of the restoring
// force, the potential U(|x1|) as a function of x1 is not a polynomial. A linear force replaces
// each even power a y^m, with the mean slope E[a m |x1|^(m-1)] of this power.
std::vector<ExponentMonomial> elastic_white_noise_exponent(const DensityEquationCoefficients& f,
                                                           const StandardDeviations& sigma) {
  const double beta = f.damping / (f.rate_times_moment[2] / 2);
  std::vector<ExponentMonomial> terms{{0, 2, -beta / 2}};
  for (int m = 0; m < static_cast<int>(numerics::Polynomial::kDegree); ++m) {
    const double odd = f.odd_force.coefficient(m), even = f.even_force.coefficient(m);
    if (odd != 0) terms.push_back({m + 1, 0, -beta * odd / (m + 1)});
    if (even != 0) {
      terms.push_back({2, 0, -beta * even * m * absolute_moment(m - 1, sigma.x1) / 2});
    }
  }
  return terms;
}

// Returns the homotopy of the solution branch: the residual R with homotopy_coefficients(), in
// units of unit_of_projected_residual(). The residual of the homotopy is linear in the fraction of
// the full problem.
Homotopy solution_branch_homotopy(const ProjectedEquations& projection,
                                  const DensityEquationCoefficients& full, double unit) {
  return {
      .residual = [=, &projection](const Eigen::VectorXd& a, double fraction) -> Eigen::VectorXd {
        return projection.residual(homotopy_coefficients(full, fraction), a) / unit;
      },
      .jacobian = [=, &projection](const Eigen::VectorXd& a, double fraction) -> Eigen::MatrixXd {
        return projection.jacobian(homotopy_coefficients(full, fraction), a) / unit;
      },
      .parameter_derivative = [=, &projection](const Eigen::VectorXd& a,
                                               double) -> Eigen::VectorXd {
        return (projection.residual(full, a) -
                projection.residual(homotopy_coefficients(full, 0), a)) /
               unit;
      }};
}

SolutionBranchEndReason branch_end_of(const SolutionCurve& curve) {
  switch (curve.end) {
    case ContinuationTermination::end_reached:
      return SolutionBranchEndReason::full_problem;
    case ContinuationTermination::fell_back:
      return SolutionBranchEndReason::white_noise;
    case ContinuationTermination::diverged:
      return SolutionBranchEndReason::far_away;
    case ContinuationTermination::step_underflow:
    case ContinuationTermination::limit_exceeded:
      break;
  }
  return SolutionBranchEndReason::lost;
}

SolutionBranch solution_branch_of(const SolutionCurve& curve, const Homotopy& family,
                                  const GaussianWeightedBasis& basis) {
  SolutionBranch branch{.end = branch_end_of(curve),
                        .furthest = curve.curve_point_with_largest_parameter().t,
                        .points = {}};
  for (const SolutionCurvePoint& point : curve.points) {
    const auto singularity_indicators =
        numerics::singularity_indicators(family.jacobian(point.a, point.t));
    branch.points.push_back(
        {.fraction = point.t,
         .norm = point.a.norm(),
         .smallest_singular_value = singularity_indicators.smallest_singular_value,
         .determinant_sign = singularity_indicators.determinant_sign,
         .falls =
             leading_form(basis.exponent_polynomial(point.a), basis.weight_standard_deviations())
                 .negative,
         .fold = false});
  }
  for (const std::size_t fold : curve.folds) branch.points[fold].fold = true;
  return branch;
}

NewtonResult root_at_curve_end(const SolutionCurve& curve, const SolutionCurvePoint& last,
                               const ProjectedEquations& projection,
                               const DensityEquationCoefficients& there, double tolerance) {
  const bool end_reached = curve.end == ContinuationTermination::end_reached;
  NewtonResult root = solve_by_newton(
      projection, there, last.a,
      {.tolerance = tolerance, .max_iterations = end_reached ? kPolishing : 0, .damped = false});
  root.converged = root.converged && end_reached;
  root.iterations += curve.iterations;
  return root;
}

}  // namespace

SolutionBranchAndRoot follow_solution_branch(const ProjectedEquations& projection,
                                             const DensityEquationCoefficients& full,
                                             double tolerance) {
  const GaussianWeightedBasis& basis = projection.basis();
  const Eigen::VectorXd exact = basis.scaled_coefficients(
      elastic_white_noise_exponent(full, basis.weight_standard_deviations()));
  const NewtonResult start = solve_by_newton(projection, homotopy_coefficients(full, 0), exact,
                                             {.tolerance = tolerance, .damped = false});
  if (!start.converged)
    return {{.end = SolutionBranchEndReason::lost, .furthest = 0, .points = {}}, start};

  const Homotopy family =
      solution_branch_homotopy(projection, full, unit_of_projected_residual(projection, full));
  const SolutionCurve curve = numerics::trace_solution_curve(
      family, start.a, {.tolerance = tolerance, .max_points = kMaxPoints});
  const SolutionCurvePoint& last = curve.curve_point_with_largest_parameter();
  NewtonResult root =
      root_at_curve_end(curve, last, projection, homotopy_coefficients(full, last.t), tolerance);
  root.iterations += start.iterations;
  return {solution_branch_of(curve, family, basis), root};
}

NewtonResult follow_newton_homotopy(const ProjectedEquations& projection,
                                    const DensityEquationCoefficients& f,
                                    const Eigen::VectorXd& start, double tolerance) {
  const double unit = unit_of_projected_residual(projection, f);
  const Homotopy family = numerics::newton_homotopy(
      [&](const Eigen::VectorXd& a) -> Eigen::VectorXd { return projection.residual(f, a) / unit; },
      [&](const Eigen::VectorXd& a) -> Eigen::MatrixXd { return projection.jacobian(f, a) / unit; },
      start);
  const SolutionCurve curve = numerics::trace_solution_curve(
      family, start, {.tolerance = tolerance, .max_points = kMaxPoints});
  return root_at_curve_end(curve, curve.points.back(), projection, f, tolerance);
}

}  // namespace fpkcheck::epc::gaussian
