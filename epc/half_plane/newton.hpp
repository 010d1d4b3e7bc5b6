#pragma once

#include <functional>

#include "epc/half_plane/galerkin_system.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Solves the Galerkin equations by a damped Newton method. The norm of a step is the standard
/// deviation of the change of Q_n under the density (step_norm). The norm of each step is at most
/// 2, and each step must shorten the next simplified Newton step (Deuflhard's natural monotonicity
/// test). The norm of the residual is residual_norm.
/// @param unit unit in which residuals are measured, see rate_of_change_unit
numerics::NewtonResult solve_by_newton(const GalerkinSystem& equations,
                                       const Eigen::VectorXd& start, double unit,
                                       const numerics::NewtonOptions& options);

/// Follows Newton's homotopy from given coefficients, past folds. The homotopy serves starts from
/// which damped Newton steps end at a singular Jacobian. The caller refines the end point of the
/// path by Newton's method.
/// @param should_stop function that is called before each step; the path ends when the function
///        returns true (deadline)
numerics::SolutionCurve follow_homotopy(const GalerkinSystem& equations,
                                        const Eigen::VectorXd& start,
                                        const std::function<bool()>& should_stop = {});

}  // namespace fpkcheck::epc::half_plane
