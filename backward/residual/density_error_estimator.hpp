#pragma once

#include <Eigen/Core>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <string>

#include "backward/control_variates/control_variate_fit.hpp"
#include "backward/residual/goal_functions.hpp"
#include "backward/residual/unresolved_residual.hpp"
#include "backward/residual/weak_residuals.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {

inline constexpr std::size_t kMomentCount = std::size(transform::kMoments);

/// Components of the L1 error estimate of a marginal density.
struct L1ErrorComponents {
  /// Sum over the smooth bins of the absolute errors of a marginal density, computed by
  /// dual-weighted residuals
  double dual_weighted_error = 0;
  /// Sum over the smooth bins of the mean residuals of the approximate solutions h of the backward
  /// equation (mean_absolute_backward_residuals())
  double unresolved_residual = 0;
  /// Half the sum over the smooth bins of the differences of the residual between wells
  /// (residual_differences_between_wells()). The well contrast is 0 if the weak residuals determine
  /// the probabilities of the potential wells, and 1 if the weak residuals do not depend on these
  /// probabilities.
  double well_contrast = 0;
};

/// Errors of a density p, computed from the density and the problem without a reference solution.
/// The arrays of errors have the order of transform::kMoments.
struct DensityErrorEstimates {
  double mass;  ///< mass of the density; all other members are values per unit mass
  transform::Moments corrected_moments;  ///< estimates E_p[f] - moment_errors of the exact E[f]
  transform::Moments moment_errors;      ///< estimated errors E_p[f] - E[f] of the moments
  /// Contributions -(h_ij - E_p[h]) rho_ij to the error of each moment, shape (functions of y,
  /// functions of v). The contributions of all splines add up to the error of a moment.
  std::array<Eigen::MatrixXd, kMomentCount> moment_error_contributions;

  /// Mean absolute residual of the backward solution h of each moment
  /// (mean_absolute_backward_residuals())
  std::array<double, kMomentCount> unresolved_residuals;
  /// Difference between wells of the residual of the backward solution h of each moment
  /// (residual_differences_between_wells())
  std::array<double, kMomentCount> residual_differences_between_wells;
  /// Components of the L1 errors of p(y) and of p(y'), over the smooth bins of
  /// make_goal_functions()
  L1ErrorComponents y_l1, ydot_l1;

  /// Returns the error estimate of a density from its dual-weighted residuals. The error estimate
  /// of a density is empty if an L1 estimate is at least 2, the L1 distance of disjoint densities.
  /// The unresolved part of the estimate is proportional to the error of the density p, since the
  /// difference (E_p - E)[e] of mean residuals is small for a nearly exact density p.
  std::optional<transform::ErrorEstimate> error_estimate() const;

  /// Safety factor of the L1 error estimates for features of a density narrower than a smooth bin.
  /// Without the safety factor, 1 in 20 of the 1389 errors of closures in random problems exceeded
  /// the L1 error estimate by a factor of 1.3 (1 in 100: 1.5; docs/limits.md).
  static constexpr double kSubBinFactor = 1.6;
};

/// Estimator of the errors of approximate stationary densities of one problem, by dual-weighted
/// residuals (Becker and Rannacher, Acta Numerica 10 (2001) 1). For a goal function f let h =
/// sum_ij h_ij A_i(y) B_j(v) solve the backward equation L h = E[f] - f, with the generator L and
/// the impact condition h(0, r u) = h(0, -u). Every density p with integral 1 satisfies
///
///     E_p[f] - E[f] = -(int p L h dy dv + int u p(0, -u) [h(0, r u) - h(0, -u)] du)
///                   = -sum_ij h_ij rho_ij,
///
/// where rho_ij are the weak residuals of p (DensityIntegrals). The estimator computes the error of
/// a density p without any other density. The fitted function h satisfies the backward equation
/// only approximately (fit_control_variate_functions()). The error of the error estimate is a
/// product of two small quantities, the residual of h in the backward equation and the error of p.
/// A constant added to the backward solution h changes the contributions h_ij rho_ij to the error
/// but not their sum. The normalisation E_p[h] = 0 of the backward solution h makes the
/// contributions h_ij rho_ij to the error comparable.
///
/// The estimated error is the deviation from the full problem with impulses: the error of a
/// solution of the white-noise equation includes the model error. The moments of a density are in
/// physical coordinates (Problem::frame), all other quantities in wall coordinates.
class DensityErrorEstimator {
 public:
  /// Numbers of spline cells for a potential with one well.
  static constexpr ControlVariateCellCounts kSingleWellCells{.y_cells = 40, .v_cells = 88};
  /// Numbers of spline cells for a potential with several wells under Gaussian white noise. A
  /// potential well is narrower than the range of y, and with kSingleWellCells the smooth bins
  /// resolve less than half of an error within a well. The fit on the spline cells for several
  /// wells takes as long as the fit on kSingleWellCells (docs/residuals.md).
  static constexpr ControlVariateCellCounts kMultipleWellCells{.y_cells = 80, .v_cells = 64};
  /// Numbers of spline cells for a potential with several wells without Gaussian white noise.
  /// Without white noise, solutions of the backward equation have a sharp bend along the orbits
  /// that end on top of a potential barrier.
  static constexpr ControlVariateCellCounts kMultipleWellCellsWithoutNoise{.y_cells = 56,
                                                                           .v_cells = 112};

  /// Fits h for all goal functions, which takes most of the computing time of an error estimate.
  /// @param problem problem in wall coordinates, like the densities of estimate_errors()
  /// @pre residuals_unsupported_reason(problem) is empty
  /// @throws LeastSquaresFitFailure (backward/generator/normal_equations.hpp)
  explicit DensityErrorEstimator(const problem::Problem& problem);
  DensityErrorEstimator(const problem::Problem& problem, const ControlVariateCellCounts& cells);

  /// Computes the errors of the moments and of the marginal densities of a density.
  /// @throws InputError for a density without positive integral, or invalid cells or range
  DensityErrorEstimates estimate_errors(const transform::Density& density) const;

  /// Distributes the contributions of the splines to an error over rectangular cells. The value of
  /// a cell is
  ///
  ///     sum_ij contribution_ij (int_cell A_i B_j dy dv / int A_i B_j dy dv) / area of the cell.
  ///
  /// The sum of values times areas over all cells is the error if the cells cover the splines.
  /// @return matrix of shape (cells of y, cells of v)
  /// @throws InputError when the edges do not increase
  Eigen::MatrixXd distribute_contributions_over_cells(const Eigen::MatrixXd& contributions,
                                                      std::span<const double> y_edges,
                                                      std::span<const double> v_edges) const;

  const numerics::QuinticBSplines& y_splines() const {
    return weak_residual_integrator_.y_splines();
  }
  const numerics::QuinticBSplines& v_splines() const {
    return weak_residual_integrator_.v_splines();
  }

 private:
  Eigen::MatrixXd backward_solution_coefficients(Eigen::Index goal_function) const;

  WeakResidualIntegrator weak_residual_integrator_;
  GoalFunctions goal_functions_;
  ControlVariateFunctions backward_solutions_;
  BackwardEquationResiduals unresolved_residual_;
};

/// Returns the reason why DensityErrorEstimator does not support a problem, in one phrase; empty if
/// the problem is supported.
std::string residuals_unsupported_reason(const problem::Problem& problem);

/// Returns the fraction of the integral of each spline that lies in each cell, shape (cells,
/// splines). Each column of fractions (one spline) sums to 1 if the cells cover the splines.
/// @throws InputError when the edges do not increase
Eigen::MatrixXd spline_integral_fractions_in_cells(const numerics::QuinticBSplines& splines,
                                                   std::span<const double> edges);

}  // namespace fpkcheck::backward
