#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "approximations/path_integration/backward_motion.hpp"
#include "approximations/path_integration/kick_matrix.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::path_integration {

/// Tensor product of the splines in y between the ends of the displacement and in the velocity v.
struct PhasePlaneSplines {
  SplineInterpolation y, v;

  /// Returns the value at (y, v) of the spline with the given coefficients; 0 outside the range.
  /// @param coefficients shape (v.size(), y.size())
  double value(const Eigen::MatrixXd& coefficients, double y, double v) const;
  /// Returns the coefficients of the spline with the given values at the points.
  Eigen::MatrixXd coefficients(const Eigen::MatrixXd& values) const {
    return v.coefficients_from_values() * values * y.coefficients_from_values().transpose();
  }
  /// Returns the integral of a spline over its range.
  double integral(const Eigen::MatrixXd& coefficients) const {
    return v.integrals().dot(coefficients * y.integrals());
  }
};

/// The transition from the density p(y, v, t) to the density p(y, v, t + T) by the
/// Chapman-Kolmogorov equation. The short-time law is Strang's splitting: impulses and noise for
/// T/2, motion with impacts for T, impulses and noise for T/2. The error of the stationary density
/// is of the order T^2. A density is given by its values at the points of the splines, shape
/// (v.size(), y.size()).
class ShortTimeOperator {
 public:
  /// @param max_motion_step largest step of the Runge-Kutta method
  ShortTimeOperator(const problem::Problem& problem, problem::DensityEquation equation,
                    const PhasePlaneSplines& splines, double time_step, double max_motion_step);

  Eigen::Index size() const { return splines_.v.size() * splines_.y.size(); }
  double time_step() const { return time_step_; }
  /// Replaces the values of a density by the values after the time T.
  void advance(Eigen::MatrixXd& values) const;

 private:
  static constexpr int kTaps = numerics::QuinticBSplines::kDegree + 1;
  // The value of a spline at the earlier state of a point, multiplied by the growth.
  struct EarlierValue {
    int first_v = 0, first_y = 0;
    std::array<double, kTaps> v{}, y{};
    double of(const Eigen::MatrixXd& coefficients) const;
  };
  EarlierValue earlier_value(const EarlierState& state) const;
  Eigen::MatrixXd kicked_values(const Eigen::MatrixXd& values) const;

  const PhasePlaneSplines& splines_;
  double time_step_;
  // Matrices of impulses and noise for T/2. One matrix, if the excitation does not depend on y, or
  // else one for each point in y.
  std::vector<Eigen::MatrixXd> half_kicks_;
  std::vector<EarlierValue> earlier_values_;  // for each point of the splines
};

struct StationarySpline {
  Eigen::MatrixXd coefficients;  ///< coefficients of the density with the integral 1
  Eigen::MatrixXd values;        ///< values of the density at the points of the splines
  /// Growth rate of the probability per unit time by truncation and interpolation, which is 0 for
  /// the exact density.
  double growth_rate = 0;
  bool has_converged = false;
};

/// Largest relative residual of the eigenvector of stationary_spline(). The slow decay of the
/// transition between two wells multiplies the residual by 1 / (1 - exp(-rate duration)) in the
/// error of the eigenvector.
inline constexpr double kEigenvectorTolerance = 1e-8;

/// Computes the eigenvector of the short-time operator with the largest eigenvalue by Arnoldi
/// iterations.
/// @param start values at which the iteration starts
/// @param duration time between two vectors of the Krylov space
StationarySpline stationary_spline(const ShortTimeOperator& short_time_operator,
                                   const PhasePlaneSplines& splines, const Eigen::MatrixXd& start,
                                   double duration);

}  // namespace fpkcheck::path_integration
