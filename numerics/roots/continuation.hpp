#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fpkcheck::numerics {

/// A homotopy G(a, t) = 0 with as many equations as the vector a has components. The solutions of a
/// homotopy form a curve in the space of (a, t).
struct Homotopy {
  template <class Result>
  using FunctionOfPoint = std::function<Result(const Eigen::VectorXd& a, double t)>;

  FunctionOfPoint<Eigen::VectorXd> residual;              ///< residual vector G(a, t)
  FunctionOfPoint<Eigen::MatrixXd> jacobian;              ///< Jacobian matrix dG/da
  FunctionOfPoint<Eigen::VectorXd> parameter_derivative;  ///< derivative dG/dt
};

/// Returns the Newton homotopy G(a, t) = R(a) - (1 - t) R(start) of the equations R(a) = 0. The
/// solution curve of the Newton homotopy begins at a = start for t = 0, and every point with t = 1
/// is a root of R.
Homotopy newton_homotopy(std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residual,
                         std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian,
                         const Eigen::VectorXd& start);

struct ContinuationOptions {
  /// Newton's method in a corrector step has converged if the largest residual max |G_i| is below
  /// `tolerance` or if the last Newton step is shorter than `correction_tolerance`.
  double tolerance = 1e-10;
  double correction_tolerance = 0;
  double first_step = 0.05;  ///< arclength of the first predictor step along the curve
  double max_step = 0.25;
  double min_step = 1e-7;
  double step_growth = 1.4;  ///< factor of the step length after a successful step
  /// Largest accepted distance between the predicted and the corrected point of the solution curve,
  /// relative to the step length. A continuation step with a larger correction is rejected, since
  /// the correction may lead to another branch of solutions.
  double max_relative_correction = 0.3;
  int max_points = 400;      ///< maximum number of steps, rejected steps included
  double max_norm = 100;     ///< upper limit of |a|, beyond which the continuation ends
  double min_t = 0;          ///< lower limit of t, below which the continuation ends
  bool locate_folds = true;  ///< whether folds are computed and added to the points
  /// Whether Newton steps correct the end point of the curve at t = 1; otherwise the end point is
  /// only interpolated.
  bool correct_end_point = true;
  /// Optional function that is called before each continuation step; the result true stops the
  /// continuation, for example at a deadline.
  std::function<bool()> should_stop = {};
};

struct SolutionCurvePoint {
  Eigen::VectorXd a;
  double t;
};

enum class ContinuationTermination {
  end_reached,     ///< the continuation reached t = 1
  fell_back,       ///< the parameter t fell to min_t
  diverged,        ///< the norm |a| exceeded max_norm
  step_underflow,  ///< the step length fell below min_step
  limit_exceeded   ///< the number of steps reached max_points, or should_stop returned true
};

struct SolutionCurve {
  /// Points of the solution curve, folds included, by increasing arclength from t = 0.
  std::vector<SolutionCurvePoint> points;
  /// Indices in `points` of the folds of the solution curve, where t has an extremum; empty without
  /// ContinuationOptions::locate_folds.
  std::vector<std::size_t> folds;
  ContinuationTermination end = ContinuationTermination::step_underflow;
  int iterations = 0;  ///< number of Newton steps

  const SolutionCurvePoint& curve_point_with_largest_parameter() const;
};

/// Computes points of the solution curve of G = 0 from (start, 0) towards t = 1 by pseudo-arclength
/// continuation (Keller). The continuation passes folds, where the matrix dG/da is singular, since
/// the solution curve is smooth as a function of arclength.
/// @param start vector that satisfies G(start, 0) = 0 within the tolerance of the options
SolutionCurve trace_solution_curve(const Homotopy& homotopy, const Eigen::VectorXd& start,
                                   const ContinuationOptions& options);

}  // namespace fpkcheck::numerics
