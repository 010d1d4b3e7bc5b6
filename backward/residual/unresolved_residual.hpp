#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/control/control_functions.hpp"
#include "backward/residual/weak_residuals.hpp"

namespace fpkcheck::backward {

/// Residuals of approximate solutions h of backward equations. The residual is e = f - U + L h in
/// the phase plane, and the jump h(0, r u) - h(0, -u) at the wall. The class stores the means of
/// |e| and of the absolute jump over cells of the splines.
class UnresolvedResidual {
 public:
  UnresolvedResidual() = default;
  /// @param fit fit of h, whose weight defines the averages over wells
  /// @param functions functions f, one function for each column of h
  UnresolvedResidual(const ControlFitProblem& fit, std::span<const SeparableFunction> functions,
                     const ControlFunctions& h);

  /// Returns the mean residual E_p|e| + int u p(0, -u) |h(0, r u) - h(0, -u)| du for each function.
  /// The integral over impacts is summed over all walls. The error (E_p - E)[f] minus its estimate
  /// -sum h rho equals (E_p - E)[e] plus a term of the jumps of h at the wall. If p is disjoint
  /// from the exact density, the error minus its estimate is about twice the mean residual.
  Eigen::VectorXd mean_residuals(const DensityIntegrals& density) const;

  /// Returns the largest difference between the means of e over any two wells, for each function; 0
  /// with one well. If the fit does not resolve the exchange between wells, the residual e is
  /// nearly constant in each well. Well probabilities with an error d then contribute d times the
  /// largest difference to (E_p - E)[e], for any value of E_p|e|. Wells of negligible mass are
  /// omitted.
  const Eigen::VectorXd& well_residual_contrasts() const { return well_contrasts_; }

 private:
  Eigen::MatrixXd in_cells_;               // shape (cells of y times cells of v, functions)
  std::vector<Eigen::MatrixXd> at_walls_;  // shape (cells of speeds, functions)
  Eigen::VectorXd well_contrasts_;
};

}  // namespace fpkcheck::backward
