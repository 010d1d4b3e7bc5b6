#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "backward/generator/collocation.hpp"

namespace fpkcheck::backward {

/// Approximate solutions of the backward equation L V = U - f, one solution for each functional f.
struct BackwardSolutions {
  /// Spline coefficients c_{ab} of A_a(y) B_b(v), shape (functions of y, functions of v). At a left
  /// wall c_{0,b} = c_{0,mirrored_index(b)} to the last bit. At a right wall the last row of
  /// coefficients has the symmetry between b and mirrored_index(b).
  std::vector<Eigen::MatrixXd> coefficients;
  std::vector<double> means;  ///< estimates U of the means E[f]
  /// Least and largest value of the residual (f + L V - U) times residual_weight at the collocation
  /// points, for each functional
  std::vector<std::pair<double, double>> residual_extremes;
};

struct LeastSquaresProblem {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementSplineSamples& y;
  const VelocityFactorSamples& v;
  /// Weight of each row of the fit, and weight of the residuals in `residual_extremes`
  std::function<double(double y, double v)> row_weight, residual_weight;
  /// Whether the solution V satisfies the impact condition of the basis `velocity` at the first and
  /// at the last knot of y
  bool has_impact_condition_at_begin = true, has_impact_condition_at_end = false;
};

/// Minimises the weighted sum of (f + L V - U)^2 over the points, for all functionals at once, by
/// conjugate gradients. The preconditioner is the block-banded Cholesky factor of the scaled normal
/// equations with a small ridge. The residuals e_f and e_1 of the fits to f and to the constant 1
/// give the mean U = <e_1, e_f> / <e_1, e_1>.
/// @param functions integrands f(y, v) of the functionals
/// @throws FitFailure (backward/generator/normal_equations.hpp)
BackwardSolutions solve_backward_equations(
    const LeastSquaresProblem& problem,
    const std::vector<std::function<double(double, double)>>& functions);

}  // namespace fpkcheck::backward
