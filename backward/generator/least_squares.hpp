#pragma once

#include <Eigen/Core>
#include <functional>
#include <utility>
#include <vector>

#include "backward/generator/collocation.hpp"

namespace fpkcheck::backward {

/// Approximate solutions of the backward equation L V = U - f, one per functional f.
struct BackwardSolutions {
  /// numerics::BernsteinCoefficients c_{ab} of A_a(y) B_b(v), shape (functions of y, functions of v), with
  /// c_{0,b} = c_{0,mirrored(b)} to the last bit where there is a wall at the left; the last ones
  /// likewise.
  std::vector<Eigen::MatrixXd> coefficients;
  std::vector<double> means;  ///< U, an estimate of E[f]
  /// The least and largest (f + L V - U) / (a weight for judging) at the points.
  std::vector<std::pair<double, double>> extremes;
};

struct LeastSquaresProblem {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementSamples& y;
  const VelocitySamples& v;
  /// Weight of a row of the fit, and of a residual that is judged.
  std::function<double(double y, double v)> row_weight, judging_weight;
  /// At which ends of y V meets the impact condition of the velocity's basis.
  bool tied_at_begin = true, tied_at_end = false;
};

/// Minimises the weighted sum of (f + L V - U)^2 over the points, for all functionals at once:
/// conjugate gradients with the scaled normal equations, a small ridge added and factorised by blocks,
/// as preconditioner. V is fitted to f
/// and to 1; the residuals e_f, e_1 give U = <e_1, e_f> / <e_1, e_1>.
/// @param functions f(y, v)
/// @throws FitBrokeDown (backward/generator/normal_equations.hpp)
BackwardSolutions solve_backward(
    const LeastSquaresProblem& problem,
    const std::vector<std::function<double(double, double)>>& functions);

}  // namespace fpkcheck::backward
