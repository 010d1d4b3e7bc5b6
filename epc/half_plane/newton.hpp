#pragma once

#include <functional>

#include "epc/half_plane/galerkin.hpp"
#include "numerics/roots/continuation.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Damped Newton's method. The norm of a step is the standard deviation of the change of Q_n under
/// the density (step_norm). It is at most 2, and each step must shorten the next simplified step
/// (Deuflhard's natural monotonicity test). Norm of the residual: residual_norm.
/// @param unit rate_unit
numerics::NewtonResult newton(const Galerkin& equations, const Eigen::VectorXd& start, double unit,
                              const numerics::NewtonOptions& options);

/// Newton's homotopy from the start, past folds. It serves starts from which damped Newton steps
/// end at a singular Jacobian. The caller refines the end by Newton's method.
/// @param should_stop called before each step; true ends the path (deadline)
numerics::SolutionCurve follow_homotopy(const Galerkin& equations, const Eigen::VectorXd& start,
                                        const std::function<bool()>& should_stop = {});

}  // namespace fpkcheck::epc::half_plane
