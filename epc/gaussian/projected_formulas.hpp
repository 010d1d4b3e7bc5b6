#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/gaussian/gaussian_weighted_basis.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Returns whether the residual F of the paper has terms that only quadrature can project: a
/// formula of the force or of the restitution coefficient, or a noise factor.
bool has_formulas(const problem::Problem& problem);

/// Terms of the residual F by formulas, projected on the basis under the Gaussian weight w,
///
///     (1/p) d/dx2 [ (f - c x2 - k x1) p + delta(x1) (1 - r(|x2|)) x2 |x2| p ]
///         + (1/p) d^2/dx2^2 [ D (G - 1) p ],      p = exp(Q_n),
///
/// where c and k are the coefficients of DensityEquationCoefficients, whose terms F contains
/// besides. The residual F has a term with the restitution coefficient r only if r is a formula. On
/// Zhuravlev's plane f and G at x1 < 0 are -f(-x1, -x2) and G(-x1, -x2).
///
/// Integration by parts moves the derivatives from the formulas, which may have kinks and jumps, to
/// the projection function phi and the Gaussian weight. With u = x2 / sigma_2^2 and the Gaussian
/// weight w, the projections of the force f and the noise factor G are
///
///     int f [Q_2 phi - phi_2 + u phi] w,
///     int D G [phi_22 - 2 u phi_2 + (u^2 - 1/sigma_2^2) phi - 2 Q_2 (phi_2 - u phi)
///              + (Q_2^2 - Q_22) phi] w.
///
/// Therefore the weighted moments int f x1^p x2^q w of the force f and int D G x1^p x2^q w of the
/// noise determine the projections for every polynomial Q_n.
class ProjectedFormulaTerms {
 public:
  /// Largest accepted quadrature error of the projected formulas of force, noise and restitution.
  static constexpr double kQuadratureTolerance = 1e-6;

  /// @param damping,stiffness coefficients c and k of the linear terms
  /// @pre has_formulas(problem)
  ProjectedFormulaTerms(const GaussianWeightedBasis& basis, const problem::Problem& problem,
                        double damping, double stiffness);

  /// Returns the formulas of force, noise and restitution projected on each basis function.
  /// @param scaled_coefficients coefficients of the polynomial Q_n in the basis
  Eigen::VectorXd projected_formula_terms(const Eigen::VectorXd& scaled_coefficients) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& scaled_coefficients) const;
  /// Returns the largest change of a weighted moment of the formulas between the last two
  /// refinements of the quadrature, relative to the largest moment; each moment is divided by the
  /// norm of its monomial.
  double projection_quadrature_error() const { return quadrature_error_; }

 private:
  void project_force_formulas(const GaussianWeightedBasis& basis, const Eigen::MatrixXd& moments);
  void project_noise_formulas(const GaussianWeightedBasis& basis, const Eigen::MatrixXd& moments);

  // Row s of the projection is the polynomial constant_ + linear_ a + a^T quadratic_[s] a of the
  // coefficients a of Q_n; quadratic_ is empty without a noise factor
  Eigen::VectorXd constant_;
  Eigen::MatrixXd linear_;
  std::vector<Eigen::MatrixXd> quadratic_;
  double quadrature_error_ = 0;
};

}  // namespace fpkcheck::epc::gaussian
