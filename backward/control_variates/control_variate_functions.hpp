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

/// Least-squares problem for the control functions h of integrands f, with the generator L:
///
///     minimise int w (f - U + L h)^2 dy dv
///              + wall_jump_weight sum_walls int u w(0, u) (h(0, r u) - h(0, -u))^2 du,
///
/// where the last integral is for a wall at y = 0.
struct ControlVariateFitProblem {
  const problem::Problem& problem;
  /// Splines A_i of displacement y from wall to wall, or over the range of the motion
  const numerics::QuinticBSplines& y_splines;
  const numerics::QuinticBSplines& v_splines;  ///< splines B_j of v
  /// Factors of the weight w(y, v) = y_weight(y) v_weight(v), which decreases slightly more slowly
  /// than the stationary density
  std::function<double(double)> y_weight, v_weight;
  /// Weight in the fit of the squared jump of the control function h at an impact, relative to the
  /// impact flux. The variance of the simulated mean is smallest if the weight of the jump at an
  /// impact is the inverse of the sampling interval.
  double wall_jump_weight;
};

/// Control functions h, approximate solutions of L h = U - f with the generator L and a constant U.
/// The control functions h need not satisfy the impact condition h(0, r u) = h(0, -u).
struct ControlVariateFunctions {
  /// Coefficients h_ij of the spline products A_i(y) B_j(v), with one column for each integrand f.
  /// The row of the coefficient h_ij is i * (number of splines of v) + j.
  Eigen::MatrixXd spline_coefficients;
  std::vector<double> mean_estimates;  ///< estimates U of the means E[f]
};

/// Fits the control functions of all integrands together (ControlVariateFitProblem). If the
/// generator has three terms (GeneratorFactors), the normal matrix of the fit is block banded: a
/// sum of nine products of a Gram matrix of v and a Gram matrix of y. The residuals e_f of the fit
/// to f and e_1 of the fit to the constant 1 give the mean U = <e_1, e_f> / <e_1, e_1>.
/// @param integrands functions f, one for each control function
/// @throws LeastSquaresFitFailure if the normal equations are not positive definite
ControlVariateFunctions fit_control_variate_functions(
    const ControlVariateFitProblem& fit_problem, const std::vector<SeparableFunction>& integrands);

}  // namespace fpkcheck::backward
