#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace fpkcheck::numerics {

/// A family of square systems G(a, t) = 0 whose solutions make a curve in (a, t).
struct Family {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> residual;  ///< G
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& a, double t)> jacobian;  ///< dG/da
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> rate;      ///< dG/dt
};

/// Newton's homotopy G(a, t) = R(a) - (1 - t) R(start): from the start, at t = 0, to a root of R at
/// t = 1.
Family newton_homotopy(std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residual,
                       std::function<Eigen::MatrixXd(const Eigen::VectorXd&)> jacobian,
                       const Eigen::VectorXd& start);

struct ArclengthOptions {
  /// A point is on the curve when max |G_s| is below the tolerance, or when the last correction was
  /// shorter than this.
  double tolerance = 1e-10;
  double short_correction = 0;
  double first_step = 0.05;  ///< of arclength in (a, t)
  double greatest_step = 0.25;
  double least_step = 1e-7;
  double growth = 1.4;  ///< of a step after one that succeeded
  /// A corrected point further from the predicted one than this share of the step may lie on
  /// another branch.
  double leash = 0.3;
  int max_points = 400;        ///< steps that failed count too
  double greatest_norm = 100;  ///< of a: a branch that leaves is not followed for ever
  double least_t = 0;          ///< nor one that falls back behind this
  bool locate_folds = true;    ///< to rounding, and record them
  bool correct_end = true;     ///< else the end is interpolated, for the caller to refine
  /// Asked before each step: whether it took too long already; may be empty.
  std::function<bool()> give_up = {};
};

/// A point of the curve.
struct CurvePoint {
  Eigen::VectorXd a;
  double t;
};

/// Why the curve was left.
enum class CurveEnd {
  arrived,   ///< at t = 1
  returned,  ///< to the least t
  far,       ///< the unknowns grew beyond all measure
  stuck,     ///< the steps shrank to nothing
  long_way   ///< the allowed number of points was spent, or the time
};

struct Curve {
  std::vector<CurvePoint> points;  ///< from t = 0 on, folds among them
  std::vector<std::size_t> folds;  ///< the points where t turns round, if they are located
  CurveEnd end = CurveEnd::stuck;
  int iterations = 0;  ///< Newton steps

  /// The point of the greatest t.
  const CurvePoint& furthest() const;
};

/// Follows the solutions of G = 0 from (start, 0) towards t = 1 by steps along the curve's own
/// length (Keller): at a fold, where dG/da is singular and t turns round, the curve itself is
/// smooth.
/// @param start a solution at t = 0, to the tolerance
Curve follow(const Family& family, const Eigen::VectorXd& start, const ArclengthOptions& options);

}  // namespace fpkcheck::numerics
