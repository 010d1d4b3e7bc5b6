#pragma once

#include <Eigen/Core>
#include <optional>

#include "epc/gaussian/basis.hpp"
#include "epc/gaussian/jump_integral_remainder.hpp"
#include "epc/gaussian/residual.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// Nonlinear equations (23) of the paper in the scaled unknowns of a basis:
///
///     R_s(a) = (1/N_s) int int F(x1, x2; a) x1^p x2^q f1(x1) f2(x2) dx1 dx2 = 0.
///
/// Every integral is exact up to rounding: each part of F is a polynomial times a factor 1, sgn(x1)
/// or |x2| delta(x1), and each factor has a Gauss rule under the Gaussian weights. Only the
/// remainder of the jump integral (`kf`) is not a polynomial, see JumpIntegralRemainder.
class ProjectedEquations {
 public:
  /// Sets up the equations without the remainder of the jump integral, for f.jump_fraction = 0.
  explicit ProjectedEquations(Basis basis);
  /// Sets up the equations with the remainder of the jump integral.
  ProjectedEquations(Basis basis, const problem::ImpulseTrain& impulses,
                     double jump_radius = JumpIntegralRemainder::kRadius);

  const Basis& basis() const { return basis_; }

  /// Residual R(a), shape (basis.size()).
  Eigen::VectorXd residual(const ResidualCoefficients& f, const Eigen::VectorXd& a) const;
  /// Jacobian: dR_s/da_k in row s and column k.
  Eigen::MatrixXd jacobian(const ResidualCoefficients& f, const Eigen::VectorXd& a) const;

 private:
  Basis basis_;
  ProjectionNodes smooth_;  // weights f1 f2
  ProjectionNodes signed_;  // weights sgn(x1) f1 f2
  ProjectionNodes impact_;  // weights delta(x1) |x2| f1 f2
  std::optional<JumpIntegralRemainder> jump_;
};

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
