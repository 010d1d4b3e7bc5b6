#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "backward/generator/generator_at_collocation_points.hpp"

namespace fpkcheck::backward {

/// Approximate solutions V = sum_ab c_ab A_a(y) B_b(v) of the backward equation L V = U - f with
/// the generator L, one solution for each integrand f.
struct BackwardEquationSolutions {
  /// Coefficients c_ab of the spline products of each solution, in a matrix of shape (functions of
  /// y, functions of v). With an impact condition at the left wall, the coefficients satisfy
  /// c_{0,b} = c_{0,basis_index_after_impact(b)} to the last bit. With an impact condition at the
  /// right wall, the last row of the coefficients is equal before and after an impact.
  std::vector<Eigen::MatrixXd> spline_coefficients;
  std::vector<double> mean_estimates;  ///< estimates U of the means E[f]
  /// Smallest and largest weighted residual (f + L V - U) over the collocation points, with the
  /// weight BackwardEquationFitProblem::residual_weight, for each solution V
  std::vector<std::pair<double, double>> residual_extremes;
};

/// Data of the least-squares fit of the backward equation at collocation points, which are the
/// tensor product of points in y and points in v.
struct BackwardEquationFitProblem {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement_basis;        ///< splines A_a of y
  const ImpactSplineBasis& velocity_basis;                ///< splines B_b of v
  const DisplacementSplineSamples& displacement_samples;  ///< A_a and A_a' at the points of y
  /// factors of L in v at the points of v
  const GeneratorVelocityFactorSamples& velocity_samples;
  /// Weight in the fit of the residual of the backward equation at a collocation point
  std::function<double(double y, double v)> row_weight;
  /// Weight of the residual of the backward equation in
  /// BackwardEquationSolutions::residual_extremes
  std::function<double(double y, double v)> residual_weight;
  /// Whether the solution V satisfies the impact condition V(wall, r u) = V(wall, -u) at the first
  /// knot of y (left wall) and at the last knot of y (right wall)
  bool has_left_impact_condition = true, has_right_impact_condition = false;
};

/// Minimises the weighted sum of the squared residuals (f + L V - U)^2 of the backward equation
/// over the collocation points, for all integrands f together, by conjugate gradients. The
/// preconditioner of the conjugate gradients is the block-banded Cholesky factor of the scaled
/// normal equations with a small ridge. The residuals e_f and e_1 of the fits to f and to the
/// constant 1 give the mean U = <e_1, e_f> / <e_1, e_1>.
/// @param integrands functions f(y, v)
/// @throws LeastSquaresFitFailure if the normal equations are not positive definite
BackwardEquationSolutions fit_backward_equation_solutions(
    const BackwardEquationFitProblem& fit_problem,
    const std::vector<std::function<double(double, double)>>& integrands);

}  // namespace fpkcheck::backward
