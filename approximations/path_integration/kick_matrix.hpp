#pragma once

#include <Eigen/Core>
#include <vector>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::path_integration {

/// Interpolation by quintic splines at the Greville abscissas, the means of five consecutive knots.
class SplineInterpolation {
 public:
  /// @param breaks distinct knots in increasing order
  explicit SplineInterpolation(const std::vector<double>& breaks);

  const numerics::QuinticBSplines& basis() const { return basis_; }
  int size() const { return basis_.size(); }
  const std::vector<double>& points() const { return points_; }
  /// Returns the matrix that computes spline coefficients from values at the points.
  const Eigen::MatrixXd& coefficients_from_values() const { return coefficients_from_values_; }
  /// Returns the integrals of the B-splines.
  const Eigen::VectorXd& integrals() const { return integrals_; }

 private:
  numerics::QuinticBSplines basis_;
  std::vector<double> points_;
  Eigen::MatrixXd coefficients_from_values_;
  Eigen::VectorXd integrals_;
};

/// Returns the matrix that computes, from the values of a density of the velocity at the points of
/// `interpolation`, the values after impulses and noise have acted for the time `duration` at the
/// fixed displacement y:
///
///     p(v, T) = exp(T (lambda (J - 1) + D d^2/dv^2)) p(v, 0),   (J p)(v) = E[p(v - b(y) Y)].
///
/// The expectations over amplitudes and over the Gaussian increments of the noise are exact for
/// splines, up to the error of a Gauss quadrature.
/// @param equation `kf`, or `white` with noise of the mean and the intensity of the impulses
/// @pre the noise factor, if present, does not depend on the velocity
Eigen::MatrixXd kick_matrix(const problem::Problem& problem, problem::DensityEquation equation,
                            double y, double duration, const SplineInterpolation& interpolation);

}  // namespace fpkcheck::path_integration
