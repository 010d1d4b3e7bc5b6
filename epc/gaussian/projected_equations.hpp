#pragma once

#include <Eigen/Core>
#include <optional>

#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "epc/gaussian/jump_integral_remainder.hpp"
#include "epc/gaussian/projected_formulas.hpp"
#include "epc/gaussian/residual.hpp"
#include "numerics/roots/newton.hpp"

namespace fpkcheck::epc::gaussian {

/// Nonlinear equations (23) of the paper for the scaled coefficients a of Q_n, with the residual F
/// and the Gaussian weights f1 f2,
///
///     R_s(a) = (1/N_s) int int F(x1, x2; a) x1^p x2^q f1(x1) f2(x2) dx1 dx2 = 0.
///
/// Gauss rules under the Gaussian weights compute each integral of (23) exactly up to rounding,
/// since each part of the residual F is a polynomial times a factor 1, sgn(x1) or |x2| delta(x1).
/// For the equation `kf` the jump integral minus its Kramers-Moyal terms is not a polynomial, and
/// JumpIntegralRemainder projects this difference. Terms of the density equation that contain
/// formulas have their own quadrature rule (ProjectedFormulaTerms).
class ProjectedEquations {
 public:
  /// Constructs projected equations without the jump integral's remainder (f.jump_fraction = 0).
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
  /// Returns the Jacobian of the projections R_s: the derivative with respect to coefficient k of
  /// Q_n is in row s and column k.
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

/// Returns the unit of the residual of the projected equations: the damping c, but at least 1e-4
/// times the frequency sigma_2/sigma_1. In a smaller unit than 1e-4 of the frequency, rounding
/// errors of the transport terms would dominate the residual of the projected equations.
double unit_of_projected_residual(const ProjectedEquations& projection,
                                  const DensityEquationCoefficients& f);

/// Solves the projected equations (23) by the paper's Newton-Raphson method with the analytic
/// Jacobian. The norm of the residual of the projected equations is max |R_s(a)| /
/// unit_of_projected_residual. With the option `damped`, each Newton step is halved until the
/// residual decreases (Armijo's rule).
numerics::NewtonResult solve_by_newton(const ProjectedEquations& projection,
                                       const DensityEquationCoefficients& f,
                                       const Eigen::VectorXd& start,
                                       const numerics::NewtonOptions& options);

}  // namespace fpkcheck::epc::gaussian
