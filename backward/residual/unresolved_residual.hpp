#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/control_variates/control_variate_functions.hpp"
#include "backward/residual/weak_residuals.hpp"

namespace fpkcheck::backward {

/// Residuals of approximate solutions h of backward equations: the residual e = f - U + L h in the
/// phase plane, and the jump h(0, r u) - h(0, -u) at each wall. An exact solution has no residuals.
/// The class stores the means of |e| over the cells of the splines and the means of the absolute
/// jump over cells of the impact speed.
class BackwardEquationResiduals {
 public:
  BackwardEquationResiduals() = default;
  /// @param fit_problem least-squares problem of h, whose weight defines the means over wells
  /// @param integrands functions f, one function for each solution h
  /// @param solutions the approximate solutions h
  BackwardEquationResiduals(const ControlVariateFitProblem& fit_problem,
                            std::span<const SeparableFunction> integrands,
                            const ControlVariateFunctions& solutions);

  /// Returns the mean residual E_p|e| + sum_walls int u p(0, -u) |h(0, r u) - h(0, -u)| du of a
  /// density p, for each solution h. The error (E_p - E)[f] minus its estimate -sum_ij h_ij rho_ij
  /// equals (E_p - E)[e] plus a term of the jumps of h at the walls. If p is disjoint from the
  /// exact density, the error minus its estimate is at most about twice the mean residual.
  Eigen::VectorXd mean_absolute_backward_residuals(const DensityIntegrals& density) const;

  /// Returns the largest difference between the means of e over any two wells of the potential, for
  /// each solution h; 0 with one well. If the fit does not resolve the exchange between wells, the
  /// residual e is nearly constant in each well. Well probabilities with an error d then contribute
  /// d times the largest difference to (E_p - E)[e], for any value of E_p|e|. Wells of negligible
  /// mass are omitted.
  const Eigen::VectorXd& residual_differences_between_wells() const {
    return well_residual_contrasts_;
  }

 private:
  Eigen::MatrixXd cell_mean_residuals_;  // means of |e|, shape (cells of y * cells of v, solutions)
  // means of the absolute jump at each wall, shape (cells of the impact speed, solutions)
  std::vector<Eigen::MatrixXd> wall_mean_jumps_;
  Eigen::VectorXd well_residual_contrasts_;
};

}  // namespace fpkcheck::backward
