#pragma once

#include <Eigen/Core>
#include <optional>

#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "epc/gaussian/jump_integral_remainder.hpp"
#include "epc/gaussian/projected_formulas.hpp"
#include "epc/gaussian/residual.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// Nonlinear equations (23) of the paper for the scaled coefficients a,
///
///     R_s(a) = (1/N_s) int int F(x1, x2; a) x1^p x2^q f1(x1) f2(x2) dx1 dx2 = 0.
///
/// Every integral is exact up to rounding, by Gauss rules under the Gaussian weights: each part of
/// F is a polynomial times a factor 1, sgn(x1) or |x2| delta(x1). For `kf` the jump integral minus
/// its Kramers-Moyal terms is not a polynomial (JumpIntegralRemainder). Terms of the density
/// equation that contain formulas have their own quadrature (ProjectedFormulaTerms).
class ProjectedEquations {
 public:
  /// Constructs the equations without the remainder of the jump integral (f.jump_fraction = 0).
  /// @param formulas terms by formulas; absent for f.formula_fraction = 0
  explicit ProjectedEquations(GaussianWeightedBasis basis,
                              std::optional<ProjectedFormulaTerms> formulas = {});
  ProjectedEquations(GaussianWeightedBasis basis, const problem::ImpulseTrain& impulses,
                     double jump_radius = JumpIntegralRemainder::kRadius,
                     std::optional<ProjectedFormulaTerms> formulas = {});

  const GaussianWeightedBasis& basis() const { return basis_; }
  const std::optional<ProjectedFormulaTerms>& formulas() const { return formulas_; }

  /// Returns R_s for every basis function s.
  Eigen::VectorXd residual(const DensityEquationCoefficients& f,
                           const Eigen::VectorXd& scaled_coefficients) const;
  /// Returns the derivative of R_s with respect to coefficient k in row s and column k.
  Eigen::MatrixXd jacobian(const DensityEquationCoefficients& f,
                           const Eigen::VectorXd& scaled_coefficients) const;

 private:
  Eigen::VectorXd projected_residual_without_formulas(
      const DensityEquationCoefficients& f, const Eigen::VectorXd& scaled_coefficients) const;
  Eigen::MatrixXd projected_jacobian_without_formulas(
      const DensityEquationCoefficients& f, const Eigen::VectorXd& scaled_coefficients) const;

  GaussianWeightedBasis basis_;
  GaussianProjectionNodes smooth_;  // nodes with the weights f1 f2
  GaussianProjectionNodes signed_;  // nodes with the weights sgn(x1) f1 f2
  GaussianProjectionNodes impact_;  // nodes with the weights delta(x1) |x2| f1 f2
  std::optional<JumpIntegralRemainder> jump_;
  std::optional<ProjectedFormulaTerms> formulas_;
};

/// Returns the unit of the residual: the damping c, but at least 1e-4 times the frequency
/// sigma_2/sigma_1. With a smaller unit, rounding errors of the transport terms would dominate the
/// residual of the projected equations.
double unit_of_projected_residual(const ProjectedEquations& projection,
                                  const DensityEquationCoefficients& f);

/// Solves the projected equations (23) by the paper's Newton-Raphson method with the analytic
/// Jacobian. The norm of the residual is max |R_s(a)| / unit_of_projected_residual. With the option
/// `damped`, each Newton step is halved until the residual decreases (Armijo's rule).
numerics::NewtonResult solve_by_newton(const ProjectedEquations& projection,
                                       const DensityEquationCoefficients& f,
                                       const Eigen::VectorXd& start,
                                       const numerics::NewtonOptions& options);

}  // namespace fpkcheck::epc::gaussian
