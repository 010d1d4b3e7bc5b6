#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/control/control_functions.hpp"
#include "backward/residual/weak_residuals.hpp"

namespace fpkcheck::backward {

/// Residuals of approximate solutions h of backward equations: e = f - U + L h in the plane and
/// h(0, r u) - h(0, -u) at the wall, as means of |e| over the cells of the splines and over cells
/// of impact speeds.
class UnresolvedResidual {
 public:
  /// @param fit the fit of h; its weight defines the averages over wells
  /// @param functions the functions f, one for each column of h
  UnresolvedResidual(const ControlFit& fit, std::span<const SeparableFunction> functions,
                     const ControlFunctions& h);

  /// E_p|e| + int u p(0, -u) |h(0, r u) - h(0, -u)| du, with the last term for each wall, for each
  /// function; p is the density of the weak form. The error (E_p - E)[f] minus its estimate
  /// -sum h rho equals (E_p - E)[e] plus the same for the jumps at the wall. For a density disjoint
  /// from the exact density this is about twice the returned value.
  Eigen::VectorXd mean_residuals(const WeakForm& density) const;

  /// Largest difference between the means of e over two wells, for each function; 0 with one well.
  /// If the exchange between wells is not resolved, e is nearly constant in each well. A density
  /// whose probabilities of the wells are wrong by d then contributes d times this difference to
  /// (E_p - E)[e], whatever E_p|e| is. Wells of negligible mass are omitted.
  const Eigen::VectorXd& contrasts() const { return contrasts_; }

 private:
  Eigen::MatrixXd in_cells_;               // shape (cells of y times cells of v, functions)
  std::vector<Eigen::MatrixXd> at_walls_;  // shape (cells of speeds, functions)
  Eigen::VectorXd contrasts_;
};

}  // namespace fpkcheck::backward
