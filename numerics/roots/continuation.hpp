#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fpkcheck::numerics {

/// A homotopy: square systems G(a, t) = 0 whose solutions form a curve in (a, t).
struct Homotopy {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> residual;  ///< G
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& a, double t)> jacobian;  ///< dG/da
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)>
      parameter_derivative;  ///< dG/dt
};

/// Newton's homotopy G(a, t) = R(a) - (1 - t) R(start). Its curve leads from the start, at t = 0,
/// to a root of R at t = 1.
Homotopy newton_homotopy(std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residual,
                         std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian,
                         const Eigen::VectorXd& start);

struct ContinuationOptions {
  /// A corrector iteration has converged when max |G_s| is below `tolerance` or its last step is
  /// shorter than `correction_tolerance`.
  double tolerance = 1e-10;
  double correction_tolerance = 0;
  double first_step = 0.05;  ///< arclength of a predictor step in (a, t)
  double max_step = 0.25;
  double min_step = 1e-7;
  double step_growth = 1.4;  ///< factor of the step length after a successful step
  /// Largest distance of the corrected from the predicted point, relative to the step length. A
  /// larger correction may lead to another branch and is rejected.
  double max_relative_correction = 0.3;
  int max_points = 400;      ///< failed steps count too
  double max_norm = 100;     ///< bound of |a|, where a diverging branch is abandoned
  double min_t = 0;          ///< bound of t, where a branch that runs backwards is abandoned
  bool locate_folds = true;  ///< locate folds to rounding and record them as points
  /// Correct the end point by Newton steps; otherwise it is interpolated, for the caller to refine.
  bool correct_end_point = true;
  /// Called before each step; true stops the continuation (a deadline, for example). May be empty.
  std::function<bool()> should_stop = {};
};

/// A point of the solution curve.
struct CurvePoint {
  Eigen::VectorXd a;
  double t;
};

/// Reason for the end of a continuation.
enum class Termination {
  end_reached,     ///< t = 1 was reached
  fell_back,       ///< t fell to min_t
  diverged,        ///< |a| exceeded max_norm
  step_underflow,  ///< the step length fell below min_step
  limit_exceeded   ///< max_points or the deadline was reached
};

struct SolutionCurve {
  std::vector<CurvePoint> points;  ///< in order from t = 0, folds included
  /// Indices of the points where t has an extremum, if they are located.
  std::vector<std::size_t> folds;
  Termination end = Termination::step_underflow;
  int iterations = 0;  ///< Newton steps

  /// The point with the largest t.
  const CurvePoint& furthest() const;
};

/// Pseudo-arclength continuation (Keller): follows the solutions of G = 0 from (start, 0) towards
/// t = 1 in steps of arclength. At a fold, where dG/da is singular and t has an extremum, the curve
/// itself is smooth.
/// @param start a solution at t = 0, to the tolerance
SolutionCurve trace_curve(const Homotopy& family, const Eigen::VectorXd& start,
                          const ContinuationOptions& options);

}  // namespace fpkcheck::numerics
