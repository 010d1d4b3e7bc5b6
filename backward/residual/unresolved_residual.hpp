#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/control_variates/control_variate_functions.hpp"
#include "backward/residual/weak_residuals.hpp"

namespace fpkcheck::backward {

/// Residuals of approximate solutions h of backward equations L h = U - f: the residual e = f - U +
/// L h in the phase plane, and the jump h(0, r u) - h(0, -u) at each wall. An exact solution has no
/// residuals. The class stores the means of the residual |e| over the cells of the splines, and the
/// means of the absolute jump at walls over cells of the impact speed.
class BackwardEquationResiduals {
 public:
  BackwardEquationResiduals() = default;
  /// @param fit_problem least-squares fit of h, whose weight defines means over potential wells
  /// @param integrands functions f, one function for each solution h
  /// @param solutions approximate solutions h of the backward equations
  BackwardEquationResiduals(const ControlVariateFitProblem& fit_problem,
                            std::span<const SeparableFunction> integrands,
                            const ControlVariateFunctions& solutions);

  /// Returns the mean residual E_p|e| + sum_walls int u p(0, -u) |h(0, r u) - h(0, -u)| du of a
  /// density p, for each solution h of a backward equation. The error (E_p - E)[f] of a mean under
  /// a density p minus its estimate -sum_ij h_ij rho_ij equals (E_p - E)[e] plus a term of the
  /// jumps of h at the walls. If a density p does not overlap the exact density, the error of a
  /// mean under p minus its estimate is at most about twice the mean residual of h.
  Eigen::VectorXd mean_absolute_backward_residuals(const DensityIntegrals& density) const;

  /// Returns the largest difference between the means of the residual e over any two wells of the
  /// potential, for each solution h of a backward equation; 0 with one well. If the fit does not
  /// resolve the transitions between potential wells, the residual e of the backward equation is
  /// nearly constant in each well. An error d of the probabilities of the wells then contributes d
  /// times the largest difference of the residual between wells to (E_p - E)[e]. Wells of
  /// negligible mass are omitted.
  const Eigen::VectorXd& residual_differences_between_wells() const {
    return well_residual_contrasts_;
  }

 private:
  Eigen::MatrixXd cell_mean_residuals_;  // means of |e|, shape (cells of y * cells of v, solutions)
  // Means of the absolute jump of h at each wall, shape (cells of the impact speed, solutions)
  std::vector<Eigen::MatrixXd> wall_mean_jumps_;
  Eigen::VectorXd well_residual_contrasts_;
};

}  // namespace fpkcheck::backward
