#pragma once

#include "epc/gaussian/projection.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// The measure of residuals: the damping c, a term of F as it stands, but at least 1e-4 of the
/// frequency sigma_2/sigma_1 of the transport terms, whose rounding would show in less.
double residual_unit(const Projection& projection, const ResidualCoefficients& f);

/// The conventional Newton-Raphson method of the paper for (23), with the analytic Jacobian. The
/// size of a residual is max |R_s(a)| / residual_unit. Damped, steps are halved until the residual
/// falls (Armijo), and the iteration ends where no step along Newton's direction makes it fall.
numerics::NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                              const Eigen::VectorXd& start, const numerics::NewtonOptions& options);

}  // namespace fpkcheck::epc::gaussian
