#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "backward/control/control_functions.hpp"
#include "backward/residual/weak_residuals.hpp"

namespace fpkcheck::backward {

/// What approximate solutions h of backward equations leave of them: e = f - U + L h in the plane
/// and h(0, r u) - h(0, -u) at the wall, as means of their sizes over the cells of the splines and
/// over speeds of impacts.
class Unresolved {
 public:
  /// @param fit what h was fitted in; its weight averages over wells
  /// @param functions f, as many as columns of h
  Unresolved(const ControlProblem& fit, std::span<const SeparableFunction> functions,
             const ControlFunctions& h);

  /// E_p|e| + int u p(0, -u) |h(0, r u) - h(0, -u)| du (the last for each wall) of each function, for the density p whose
  /// weak form is given. (E_p - E)[f], less what -sum h rho says of it, is (E_p - E)[e] and the
  /// like at the wall: if p were as far off as can be, twice this.
  Eigen::VectorXd of(const WeakForm& density) const;

  /// The largest difference between the means of e in two wells, of each function; 0 with one well.
  /// Where exchange between wells is not resolved, e is about constant in each of them, and a density
  /// whose shares of the wells are wrong by d leaves d times the difference in (E_p - E)[e], whatever
  /// E_p|e| is. Wells of negligible mass are left out.
  const Eigen::VectorXd& contrasts() const { return contrasts_; }

 private:
  Eigen::MatrixXd in_cells_;               // shape (cells of y times cells of v, functions)
  std::vector<Eigen::MatrixXd> at_walls_;  // shape (cells of speeds, functions)
  Eigen::VectorXd contrasts_;
};

}  // namespace fpkcheck::backward
