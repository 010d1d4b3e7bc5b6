#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "backward/generator/generator_at_collocation_points.hpp"

namespace fpkcheck::backward {

/// Approximate solutions V = sum_ab c_ab A_a(y) B_b(v) of the backward equation L V = U - f, one
/// solution for each integrand f.
struct BackwardEquationSolutions {
  /// Coefficients c_ab of each solution, shape (functions of y, functions of v). With an impact
  /// condition at the left wall, c_{0,b} = c_{0,basis_index_after_impact(b)} to the last bit. With
  /// an impact condition at the right wall, the last row of coefficients has the same symmetry.
  std::vector<Eigen::MatrixXd> spline_coefficients;
  std::vector<double> mean_estimates;  ///< estimates U of the means E[f]
  /// Smallest and largest value over the collocation points of the residual (f + L V - U) times
  /// BackwardEquationFitProblem::residual_weight, for each solution
  std::vector<std::pair<double, double>> residual_extremes;
};

/// Inputs of the least-squares fit of the backward equation at collocation points, which are the
/// tensor product of the points of `displacement_samples` and `velocity_samples`.
struct BackwardEquationFitProblem {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement_basis;        ///< splines A_a of y
  const ImpactSplineBasis& velocity_basis;                ///< splines B_b of v
  const DisplacementSplineSamples& displacement_samples;  ///< A_a and A_a' at the points of y
  /// factors of L in v at the points of v
  const GeneratorVelocityFactorSamples& velocity_samples;
  /// Weight by which the fit multiplies the residual at a point
  std::function<double(double y, double v)> row_weight;
  /// Weight of the residual in BackwardEquationSolutions::residual_extremes
  std::function<double(double y, double v)> residual_weight;
  /// Whether V satisfies the impact condition V(wall, r u) = V(wall, -u) at the first knot of y
  /// (left wall) and at the last knot of y (right wall)
  bool has_left_impact_condition = true, has_right_impact_condition = false;
};

/// Minimises the weighted sum of (f + L V - U)^2 over the collocation points, for all integrands
/// together, by conjugate gradients. The preconditioner is the block-banded Cholesky factor of the
/// scaled normal equations with a small ridge. The residuals e_f and e_1 of the fits to f and to
/// the constant 1 give the mean U = <e_1, e_f> / <e_1, e_1>.
/// @param integrands functions f(y, v)
/// @throws LeastSquaresFitFailure (backward/generator/normal_equations.hpp)
BackwardEquationSolutions fit_backward_equation_solutions(
    const BackwardEquationFitProblem& fit_problem,
    const std::vector<std::function<double(double, double)>>& integrands);

}  // namespace fpkcheck::backward
