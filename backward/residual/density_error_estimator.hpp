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

/// Components of the error of a marginal density in the L1 norm.
struct L1ErrorComponents {
  /// Sum over the smooth bins of the absolute errors, computed by dual-weighted residuals
  double dual_weighted_error = 0;
  /// Sum over the smooth bins of BackwardEquationResiduals::mean_absolute_backward_residuals(), the
  /// residuals of the approximate backward solutions h
  double unresolved_residual = 0;
  /// Half the sum over the smooth bins of
  /// BackwardEquationResiduals::residual_differences_between_wells(). The value is 0 if the weak
  /// residuals determine the probabilities of the wells, and 1 if the weak residuals do not depend
  /// on the probabilities.
  double well_contrast = 0;
};

/// Errors of a density p, computed from the density and the problem alone. The arrays have the
/// order of transform::kMoments.
struct DensityErrorEstimates {
  double mass;  ///< mass of the density; all other members are values per unit mass
  transform::Moments corrected_moments;  ///< estimates E_p[f] - moment_errors of the exact E[f]
  transform::Moments moment_errors;      ///< estimated errors E_p[f] - E[f] of the moments
  /// Contributions -(h_ij - E_p[h]) rho_ij to the error of each moment, shape (functions of y,
  /// functions of v). The sum of the contributions is the error of the moment.
  std::array<Eigen::MatrixXd, kMomentCount> moment_error_contributions;

  /// BackwardEquationResiduals::mean_absolute_backward_residuals() of each moment
  std::array<double, kMomentCount> unresolved_residuals;
  /// BackwardEquationResiduals::residual_differences_between_wells() of each moment
  std::array<double, kMomentCount> residual_differences_between_wells;
  /// Components of the L1 errors of p(y) and of p(y'), over the bins of make_goal_functions()
  L1ErrorComponents y_l1, ydot_l1;

  /// Returns the error estimate of the density. The result is empty if an L1 estimate is at least
  /// 2, the L1 distance of disjoint densities. The unresolved part of the estimate is proportional
  /// to the error of p, since (E_p - E)[e] is small for a nearly exact density p, where e is the
  /// residual of h.
  std::optional<transform::ErrorEstimate> error_estimate() const;

  /// Factor of the L1 error estimates for features narrower than a bin. Without this factor, 1 in
  /// 20 of the 1389 errors of closures in random problems exceeded the estimate by a factor of 1.3
  /// (1 in 100: 1.5; docs/limits.md).
  static constexpr double kSubBinFactor = 1.6;
};

/// Estimator of the errors of approximate stationary densities of one problem, by dual-weighted
/// residuals (Becker and Rannacher, Acta Numerica 10 (2001) 1). For a goal function f let h =
/// sum_ij h_ij A_i(y) B_j(v) solve the backward equation L h = E[f] - f with the impact condition
/// h(0, r u) = h(0, -u). For any density p of mass 1
///
///     E_p[f] - E[f] = -(int p L h dy dv + int u p(0, -u) [h(0, r u) - h(0, -u)] du)
///                   = -sum_ij h_ij rho_ij,
///
/// with the weak residuals rho_ij of p (DensityIntegrals). The error of p is computed without any
/// other density. The fitted h satisfies the backward equation only approximately
/// (fit_control_variate_functions()). The error of the estimate is a product of two small
/// quantities, the residual of h and the error of p. A constant added to h changes the
/// contributions h_ij rho_ij but not the sum of all contributions. The normalisation E_p[h] = 0
/// makes the contributions comparable.
///
/// The reference of the error is the full problem with impulses: the error of a solution of the
/// white-noise equation includes the model error. Moments are in physical coordinates
/// (Problem::frame), all other quantities in wall coordinates.
class DensityErrorEstimator {
 public:
  /// Numbers of spline cells for a potential with one well.
  static constexpr ControlVariateCellCounts kSingleWellCells{.y_cells = 40, .v_cells = 88};
  /// Numbers of spline cells for a potential with several wells under Gaussian noise. A well is
  /// narrower than the range of y, and with kSingleWellCells the bins resolve less than half of an
  /// error within a well. The fit takes as long as the fit on kSingleWellCells (docs/residuals.md).
  static constexpr ControlVariateCellCounts kMultipleWellCells{.y_cells = 80, .v_cells = 64};
  /// Numbers of spline cells for a potential with several wells without Gaussian noise. Without
  /// noise solutions of the backward equation have a sharp bend along the orbits that end on top of
  /// a barrier.
  static constexpr ControlVariateCellCounts kMultipleWellCellsWithoutNoise{.y_cells = 56,
                                                                           .v_cells = 112};

  /// Fits h for all goal functions, which takes most of the computing time of an error estimate.
  /// @param problem problem in wall coordinates, like the densities of estimate_errors()
  /// @pre residuals_unsupported_reason(problem) is empty
  /// @throws LeastSquaresFitFailure (backward/generator/normal_equations.hpp)
  explicit DensityErrorEstimator(const problem::Problem& problem);
  DensityErrorEstimator(const problem::Problem& problem, const ControlVariateCellCounts& cells);

  /// Computes the errors of the moments and of the marginals of a density.
  /// @throws InputError when the mass is not positive, or the cells or the range are invalid
  DensityErrorEstimates estimate_errors(const transform::Density& density) const;

  /// Distributes the contributions to an error over rectangular cells. The value of a cell is
  ///
  ///     sum_ij contribution_ij (int_cell A_i B_j dy dv / int A_i B_j dy dv) / area of the cell.
  ///
  /// The sum of values times areas of the cells is the error if the cells cover the splines.
  /// @return shape (cells of y, cells of v)
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
/// functions). Each column sums to 1 if the cells cover the splines.
/// @throws InputError when the edges do not increase
Eigen::MatrixXd spline_integral_fractions_in_cells(const numerics::QuinticBSplines& splines,
                                                   std::span<const double> edges);

}  // namespace fpkcheck::backward
