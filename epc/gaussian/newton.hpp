#pragma once

#include "epc/gaussian/projected_equations.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// Unit in which residuals are measured: the damping c, which is a term of F, but at least 1e-4
/// times sigma_2/sigma_1, the frequency of the transport terms. In a smaller unit, the rounding
/// errors of the transport terms would dominate the residual.
double residual_unit(const ProjectedEquations& projection, const ResidualCoefficients& f);

/// Solves (23) by the paper's Newton-Raphson method, with the analytic Jacobian. The norm of the
/// residual is max |R_s(a)| / residual_unit. With the option `damped`, each step is halved until
/// the residual decreases (Armijo's rule). The iteration ends if no step in Newton's direction
/// decreases the residual.
numerics::NewtonResult solve_by_newton(const ProjectedEquations& projection,
                                       const ResidualCoefficients& f, const Eigen::VectorXd& start,
                                       const numerics::NewtonOptions& options);

}  // namespace fpkcheck::epc::gaussian
