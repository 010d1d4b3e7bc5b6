#pragma once

#include <Eigen/Core>
#include <array>
#include <iterator>
#include <optional>
#include <span>
#include <string>

#include "backward/control/control_function_fit.hpp"
#include "backward/residual/goal_functions.hpp"
#include "backward/residual/unresolved_residual.hpp"
#include "backward/residual/weak_residuals.hpp"
#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::backward {

inline constexpr std::size_t kMomentCount = std::size(transform::kMoments);

struct ErrorComponents {
  double found = 0;  ///< L1 error computed by the dual-weighted residuals
  /// Mean residuals (UnresolvedResidual) of the functions h that weight the residuals of the
  /// density
  double unresolved = 0;
  /// Half the sum of UnresolvedResidual::well_residual_contrasts(). The contrast is 0 if the
  /// residuals determine the probabilities of the wells, and 1 if the residuals do not depend on
  /// the probabilities.
  double contrast = 0;
};

/// Errors of a density, computed from the density and the problem alone.
struct DensityErrors {
  double mass;  ///< mass of the density; all other members are values per unit mass
  transform::Moments corrected;  ///< estimates of the exact moments E[f]
  transform::Moments error;      ///< errors E_p[f] - corrected of the moments of the density
  /// Contributions -(h_ij - E_p[h]) rho_ij to the error of each of transform::kMoments, shape
  /// (functions of y, functions of v). The contributions to the error of a moment sum to the error
  /// of the moment.
  std::array<Eigen::MatrixXd, kMomentCount> contributions;

  std::array<double, kMomentCount> unresolved;
  std::array<double, kMomentCount> well_residual_contrasts;
  /// L1 errors of p(y) and of p(y'), over the bins of goal_functions()
  ErrorComponents y_l1, ydot_l1;

  /// Returns the error estimate of the density; empty if an L1 estimate is at least 2, the L1
  /// distance of disjoint densities. The unresolved part of the estimate is proportional to the
  /// error, since the error (E_p - E)[e] of the mean residual is small for a nearly exact density
  /// p.
  std::optional<transform::ErrorEstimate> error_estimate() const;

  /// Factor of the L1 error estimates for features narrower than a bin. Without this factor, 1 in
  /// 20 of the 1389 errors of closures in random problems exceeded the estimate by a factor of 1.3
  /// (1 in 100: 1.5; docs/limits.md).
  static constexpr double kSubBinFactor = 1.6;
};

/// Computes errors of densities by dual-weighted residuals. Let h = sum h_ij A_i(y) B_j(v) solve L
/// h = E[f] - f with h(0, r u) = h(0, -u). For any density p of mass 1
///
///     E_p[f] - E[f] = -(int p L h dy dv + int u p(0, -u) [h(0, r u) - h(0, -u)] du)
///                   = -sum_ij h_ij rho_ij,
///
/// with the weak residuals rho_ij of p (WeakResiduals). The error of p is computed without any
/// other density (Becker and Rannacher, Acta Numerica 10 (2001) 1). The fitted h solves the
/// equations L h = E[f] - f only approximately (fit_control_functions). The remaining error is a
/// product of two small quantities, the residual of h and the error of p. A constant added to h
/// changes the contributions h_ij rho_ij but not the sum of all contributions. The normalisation
/// E_p[h] = 0 makes the contributions comparable.
///
/// The reference of the error is the full problem with impulses: the error of a solution of the
/// white-noise equation includes the model error. Moments are in physical coordinates
/// (Problem::frame), all other quantities in wall coordinates.
class DensityResiduals {
 public:
  static constexpr ControlCells kCells{.y = 40, .v = 88};
  /// Numbers of spline cells for a potential with several wells under Gaussian noise. A well is
  /// narrower than the range of y, and with kCells the bins resolve less than half of an error
  /// within a well. The fit on kWellCells takes as long as the fit on kCells (docs/residuals.md).
  static constexpr ControlCells kWellCells{.y = 80, .v = 64};
  /// Numbers of spline cells for a potential with several wells without Gaussian noise. Without
  /// noise solutions of the backward equation have a sharp bend along the orbits that end on top of
  /// a barrier.
  static constexpr ControlCells kSharpWellCells{.y = 56, .v = 112};

  /// Fits h, which takes most of the computing time of an error estimate.
  /// @param problem in wall coordinates, like the densities of estimate_errors()
  /// @pre residuals_unsupported_reason(problem) is empty
  /// @throws FitFailure (backward/generator/normal_equations.hpp)
  explicit DensityResiduals(const problem::Problem& problem);
  DensityResiduals(const problem::Problem& problem, const ControlCells& cells);

  /// @throws InputError when the mass is not positive, or the cells or the range are invalid
  DensityErrors estimate_errors(const transform::Density& density) const;

  /// Distributes the contributions to an error over rectilinear cells. The value of a cell is
  ///
  ///     sum_ij contribution_ij (int_cell A_i B_j dy dv / int A_i B_j dy dv) / area.
  ///
  /// The sum of values times areas of the cells is the error if the cells cover the splines.
  /// @return shape (cells of y, cells of v)
  /// @throws InputError when the edges do not increase
  Eigen::MatrixXd contributions_per_cell(const Eigen::MatrixXd& contributions,
                                         std::span<const double> y_edges,
                                         std::span<const double> v_edges) const;

  const numerics::QuinticBSplines& y() const { return residuals_.y(); }
  const numerics::QuinticBSplines& v() const { return residuals_.v(); }

 private:
  Eigen::MatrixXd backward_solution(Eigen::Index goal_function) const;

  WeakResiduals residuals_;
  GoalFunctions functions_;
  ControlFunctions h_;
  UnresolvedResidual unresolved_;
};

/// Returns the reason why DensityResiduals does not support a problem, in one phrase; empty if the
/// problem is supported.
std::string residuals_unsupported_reason(const problem::Problem& problem);

/// Returns the fraction of the integral of each spline in each cell, shape (cells, functions). The
/// columns sum to 1 if the cells cover the splines.
/// @throws InputError when the edges do not increase
Eigen::MatrixXd spline_fractions_in_cells(const numerics::QuinticBSplines& splines,
                                          std::span<const double> edges);

}  // namespace fpkcheck::backward
