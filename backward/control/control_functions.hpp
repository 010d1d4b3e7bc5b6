#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "numerics/splines/knot_splines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// f(y, v) = of_y(y) of_v(v).
struct SeparableFunction {
  std::function<double(double)> of_y, of_v;
};

/// What the control functions are fitted in, and how.
struct ControlProblem {
  const problem::Problem& problem;
  const numerics::KnotSplines& y;  ///< from wall to wall, or as far as there is motion
  const numerics::KnotSplines& v;
  /// w(y, v) = weight_y weight_v, somewhat wider than the density.
  std::function<double(double)> weight_y, weight_v;
  /// What the square of a jump at a wall counts, by the flux u w(wall, u) of impacts: the time
  /// between the samples of the simulation, inverted, makes the least variance of its mean.
  double wall_weight;
};

/// Approximate solutions h of the backward equation L h = U - f, which need not satisfy the impact
/// condition.
struct ControlFunctions {
  /// Coefficient of A_i(y) B_j(v) in row i * v.size() + j, a column a functional.
  Eigen::MatrixXd coefficients;
  std::vector<double> means;  ///< U, an estimate of E[f]
};

/// Minimises int w (f - U + L h)^2 + wall_weight int u w(0, u) (h(0, r u) - h(0, -u))^2 du (the last
/// for each wall) for all functionals at once. The generator is a sum of products
/// (GeneratorFactors) and the weight is one: nine Gram matrices of v and of y, for three products,
/// make the normal matrix, which is banded by blocks and factorised so. With the residuals e of f
/// and of 1, U = <e_1, e_f> / <e_1, e_1>.
/// @throws FitBrokeDown (backward/generator/normal_equations.hpp)
ControlFunctions control_functions(const ControlProblem& problem,
                                   const std::vector<SeparableFunction>& functions);

}  // namespace fpkcheck::backward
