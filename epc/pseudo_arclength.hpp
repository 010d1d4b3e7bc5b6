#pragma once

#include <functional>
#include <vector>

#include <Eigen/Dense>

namespace fpkcheck::epc {

/// A family of square systems G(a, t) = 0 whose solutions make a curve in (a, t).
struct Family {
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> residual;  ///< G
  std::function<Eigen::MatrixXd(const Eigen::VectorXd& a, double t)> jacobian;  ///< dG/da
  std::function<Eigen::VectorXd(const Eigen::VectorXd& a, double t)> rate;      ///< dG/dt
};

struct ArclengthOptions {
  double tolerance = 1e-10;  ///< on max |G_s|
  double first_step = 0.05;  ///< of arclength in (a, t)
  double greatest_step = 0.25;
  double least_step = 1e-7;
  int max_points = 400;
  double greatest_norm = 100;  ///< of a: a branch that leaves is not followed for ever
};

/// A point of the curve.
struct CurvePoint {
  Eigen::VectorXd a;
  double t;
  double smallest_singular_value;  ///< of dG/da
  int determinant_sign;            ///< of dG/da: -1, 0 or 1
};

/// Why the curve was left.
enum class CurveEnd {
  arrived,   ///< at t = 1
  returned,  ///< to t = 0
  far,       ///< the unknowns grew beyond all measure
  stuck,     ///< the steps shrank to nothing
  long_way   ///< the allowed number of points was spent
};

struct Curve {
  std::vector<CurvePoint> points;  ///< from t = 0 on, folds among them
  std::vector<std::size_t> folds;  ///< the points where t turns round
  CurveEnd end = CurveEnd::stuck;
  int iterations = 0;  ///< Newton steps

  /// The point of the greatest t.
  const CurvePoint& furthest() const;
};

/// Follows the solutions of G = 0 from (start, 0) towards t = 1 by steps along the curve's own
/// length (Keller): at a fold, where dG/da is singular and t turns round, the curve itself is
/// smooth. Each fold is located to rounding.
/// @param start a solution at t = 0, to the tolerance
Curve follow(const Family& family, const Eigen::VectorXd& start, const ArclengthOptions& options);

}  // namespace fpkcheck::epc
