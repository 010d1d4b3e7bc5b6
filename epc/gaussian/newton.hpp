#pragma once

#include "epc/gaussian/projection.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// Unit of residuals: the damping c, which is a term of F, but at least 1e-4 of the frequency
/// sigma_2/sigma_1 of the transport terms. A smaller unit would resolve their rounding errors.
double residual_unit(const Projection& projection, const ResidualCoefficients& f);

/// Newton-Raphson method of the paper for (23), with the analytic Jacobian. Norm of the residual:
/// max |R_s(a)| / residual_unit. With the option `damped`, steps are halved until the residual
/// decreases (Armijo). The iteration ends if no step in Newton's direction decreases it.
numerics::NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                              const Eigen::VectorXd& start, const numerics::NewtonOptions& options);

}  // namespace fpkcheck::epc::gaussian
