#pragma once

#include <functional>

#include "epc/half_plane/galerkin.hpp"
#include "numerics/roots/arclength.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::half_plane {

/// Newton's method, damped by what is measured, as all else here, by the standard deviation of the
/// change of Q_n under the density: no step changes it by more than 2, and each must shorten the
/// next simplified step (Deuflhard's natural monotonicity test). A residual's size is size_of.
/// @param unit rate_unit
numerics::NewtonResult newton(const Galerkin& equations, const Eigen::VectorXd& start, double unit,
                              const numerics::NewtonOptions& options);

/// Newton's homotopy from the start, past folds. It rescues starts from which damped Newton steps
/// end at a point where the Jacobian is singular. The end is to be refined by Newton's method.
/// @param give_up asked before each step: whether it took too long already
numerics::Curve follow_homotopy(const Galerkin& equations, const Eigen::VectorXd& start,
                                const std::function<bool()>& give_up = {});

}  // namespace fpkcheck::epc::half_plane
