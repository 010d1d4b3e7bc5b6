#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Product f(y, v) = y_factor(y) v_factor(v).
struct SeparableFunction {
  std::function<double(double)> y_factor, v_factor;
};

struct ControlFitProblem {
  const problem::Problem& problem;
  /// Splines of y from wall to wall, or over the range of the motion
  const numerics::QuinticBSplines& y;
  const numerics::QuinticBSplines& v;
  /// Factors of the weight w(y, v) = weight_y(y) weight_v(v), which is slightly wider than the
  /// density
  std::function<double(double)> weight_y, weight_v;
  /// Weight of the squared jump of h at a wall, which is integrated with the flux u w(wall, u) of
  /// impacts. The variance of the simulated mean is smallest if wall_weight is the inverse of the
  /// sampling interval.
  double wall_weight;
};

/// Approximate solutions h of the backward equation L h = U - f. The functions h need not satisfy
/// the impact condition.
struct ControlFunctions {
  /// Coefficients of A_i(y) B_j(v) in row i * v.size() + j, with one column for each functional
  Eigen::MatrixXd coefficients;
  std::vector<double> means;  ///< estimates U of the means E[f]
};

/// Fits the control functions of all functionals at once. The fit minimises int w (f - U + L h)^2 +
/// wall_weight int u w(0, u) (h(0, r u) - h(0, -u))^2 du, with the last term for each wall. With
/// three GeneratorFactors the normal matrix is block banded: a sum of nine products of a Gram
/// matrix of v and a Gram matrix of y. The residual e_f of the fit to f and the residual e_1 of the
/// fit to the constant 1 give the mean U = <e_1, e_f> / <e_1, e_1>.
/// @throws FitFailure (backward/generator/normal_equations.hpp)
ControlFunctions fit_control_functions(const ControlFitProblem& problem,
                                       const std::vector<SeparableFunction>& functions);

}  // namespace fpkcheck::backward
