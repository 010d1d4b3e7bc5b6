#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fpkcheck::numerics {

/// A homotopy: square systems G(a, t) = 0 whose solutions form a curve in (a, t).
struct Family {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> residual;  ///< G
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& a, double t)> jacobian;  ///< dG/da
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> rate;      ///< dG/dt
};

/// Newton's homotopy G(a, t) = R(a) - (1 - t) R(start). Its curve leads from the start, at t = 0,
/// to a root of R at t = 1.
Family newton_homotopy(std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residual,
                       std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian,
                       const Eigen::VectorXd& start);

struct ArclengthOptions {
  /// A corrector iteration has converged when max |G_s| is below `tolerance` or its last step is
  /// shorter than `correction_tolerance`.
  double tolerance = 1e-10;
  double short_correction = 0;
  double first_step = 0.05;  ///< arclength of a predictor step in (a, t)
  double greatest_step = 0.25;
  double least_step = 1e-7;
  double growth = 1.4;  ///< factor of the step length after a successful step
  /// Largest distance of the corrected from the predicted point, relative to the step length. A
  /// larger correction may lead to another branch and is rejected.
  double leash = 0.3;
  int max_points = 400;        ///< failed steps count too
  double greatest_norm = 100;  ///< bound of |a|, where a diverging branch is abandoned
  double least_t = 0;          ///< bound of t, where a branch that runs backwards is abandoned
  bool locate_folds = true;    ///< locate folds to rounding and record them as points
  /// Correct the end point by Newton steps; otherwise it is interpolated, for the caller to refine.
  bool correct_end = true;
  /// Called before each step; true stops the continuation (a deadline, for example). May be empty.
  std::function<bool()> give_up = {};
};

/// A point of the solution curve.
struct CurvePoint {
  Eigen::VectorXd a;
  double t;
};

/// Reason for the end of a continuation.
enum class CurveEnd {
  arrived,   ///< t = 1 was reached
  returned,  ///< t fell to min_t
  far,       ///< |a| exceeded max_norm
  stuck,     ///< the step length fell below min_step
  long_way   ///< max_points or the deadline was reached
};

struct Curve {
  std::vector<CurvePoint> points;  ///< in order from t = 0, folds included
  /// Indices of the points where t has an extremum, if they are located.
  std::vector<std::size_t> folds;
  CurveEnd end = CurveEnd::stuck;
  int iterations = 0;  ///< Newton steps

  /// The point with the largest t.
  const CurvePoint& furthest() const;
};

/// Pseudo-arclength continuation (Keller): follows the solutions of G = 0 from (start, 0) towards
/// t = 1 in steps of arclength. At a fold, where dG/da is singular and t has an extremum, the curve
/// itself is smooth.
/// @param start a solution at t = 0, to the tolerance
Curve follow(const Family& family, const Eigen::VectorXd& start, const ArclengthOptions& options);

}  // namespace fpkcheck::numerics
