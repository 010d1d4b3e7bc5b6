#include "epc/pseudo_arclength.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fpkcheck::epc {
namespace {

constexpr int kCorrections = 6;
constexpr double kGrowth = 1.4;
// A corrected point further from the predicted one than this share of the step may lie on another
// branch.
constexpr double kLeash = 0.3;
constexpr int kFoldBisections = 40;

// (a, t) as one vector.
struct Point {
  Eigen::VectorXd a;
  double t;
};

class Follower {
 public:
  Follower(const Family& family, const ArclengthOptions& options)
      : family_(family), options_(options) {}

  Curve from(const Eigen::VectorXd& start);

 private:
  Point predicted(const Point& from, const Eigen::VectorXd& tangent, double step) const {
    return {from.a + step * tangent.head(from.a.size()), from.t + step * tangent[from.a.size()]};
  }
  Eigen::MatrixXd bordered(const Point& at, const Eigen::VectorXd& last_row) const;
  Eigen::VectorXd tangent(const Point& at, const Eigen::VectorXd& before) const;
  std::optional<Point> corrected(const Point& predicted, const Eigen::VectorXd& tangent,
                                 double step);
  std::optional<Point> corrected_at(Point point);
  Point fold_after(const Point& from, const Eigen::VectorXd& tangent, double step);
  void record(const Point& at);

  const Family& family_;
  const ArclengthOptions& options_;
  Curve curve_;
};

Eigen::MatrixXd Follower::bordered(const Point& at, const Eigen::VectorXd& last_row) const {
  const Eigen::Index n = at.a.size();
  Eigen::MatrixXd matrix(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = family_.jacobian(at.a, at.t);
  matrix.col(n).head(n) = family_.rate(at.a, at.t);
  matrix.row(n) = last_row.transpose();
  return matrix;
}

// The unit tangent that goes on in the direction of the one before.
Eigen::VectorXd Follower::tangent(const Point& at, const Eigen::VectorXd& before) const {
  const Eigen::Index n = at.a.size();
  return bordered(at, before).partialPivLu().solve(Eigen::VectorXd::Unit(n + 1, n)).normalized();
}

// Newton steps in the plane through the predicted point across the tangent.
std::optional<Point> Follower::corrected(const Point& start, const Eigen::VectorXd& tangent,
                                         double step) {
  const Eigen::Index n = start.a.size();
  Point point = start;
  Eigen::VectorXd residual = family_.residual(point.a, point.t);
  for (int i = 0; i < kCorrections; ++i) {
    Eigen::VectorXd right(n + 1);
    right << -residual, 0;
    const Eigen::VectorXd change = bordered(point, tangent).partialPivLu().solve(right);
    point.a += change.head(n);
    point.t += change[n];
    ++curve_.iterations;
    residual = family_.residual(point.a, point.t);
    const double size = residual.lpNorm<Eigen::Infinity>();
    if (!std::isfinite(size)) return std::nullopt;
    if (size < options_.tolerance) {
      const double strayed = std::hypot((point.a - start.a).norm(), point.t - start.t);
      return strayed < kLeash * std::abs(step) ? std::optional(point) : std::nullopt;
    }
  }
  return std::nullopt;
}

// Newton steps at fixed t.
std::optional<Point> Follower::corrected_at(Point point) {
  Eigen::VectorXd residual = family_.residual(point.a, point.t);
  for (int i = 0; i < kCorrections; ++i) {
    point.a -= family_.jacobian(point.a, point.t).partialPivLu().solve(residual);
    ++curve_.iterations;
    residual = family_.residual(point.a, point.t);
    if (residual.lpNorm<Eigen::Infinity>() < options_.tolerance) return point;
  }
  return std::nullopt;
}

// The point where t is stationary, between a point and a step further on.
Point Follower::fold_after(const Point& from, const Eigen::VectorXd& tangent_there, double step) {
  const Eigen::Index n = from.a.size();
  double low = 0, high = step;
  Point fold = from;
  for (int i = 0; i < kFoldBisections; ++i) {
    const double middle = (low + high) / 2;
    const auto point = corrected(predicted(from, tangent_there, middle), tangent_there, step);
    if (!point) break;
    fold = *point;
    (tangent(fold, tangent_there)[n] * tangent_there[n] > 0 ? low : high) = middle;
  }
  return fold;
}

void Follower::record(const Point& at) {
  const Eigen::MatrixXd jacobian = family_.jacobian(at.a, at.t);
  const double determinant = jacobian.partialPivLu().determinant();
  curve_.points.push_back(
      {.a = at.a,
       .t = at.t,
       .smallest_singular_value = jacobian.jacobiSvd().singularValues().minCoeff(),
       .determinant_sign = determinant > 0   ? 1
                           : determinant < 0 ? -1
                                             : 0});
}

Curve Follower::from(const Eigen::VectorXd& start) {
  const Eigen::Index n = start.size();
  Point at{start, 0};
  Eigen::VectorXd direction = tangent(at, Eigen::VectorXd::Unit(n + 1, n));
  record(at);
  double step = options_.first_step;
  int left = options_.max_points;
  while (left-- > 0) {
    const auto next = corrected(predicted(at, direction, step), direction, step);
    if (!next) {
      step /= 2;
      if (step < options_.least_step) {
        curve_.end = CurveEnd::stuck;
        return curve_;
      }
      continue;
    }
    const Eigen::VectorXd onwards = tangent(*next, direction);
    if (onwards[n] * direction[n] < 0) {
      record(fold_after(at, direction, step));
      curve_.folds.push_back(curve_.points.size() - 1);
    }
    const double end = next->t >= 1 ? 1 : 0;
    if (next->t >= 1 || next->t <= 0) {
      const double share = (end - at.t) / (next->t - at.t);
      const auto landed = corrected_at({at.a + share * (next->a - at.a), end});
      if (landed) record(*landed);
      curve_.end = !landed ? CurveEnd::stuck : end == 1 ? CurveEnd::arrived : CurveEnd::returned;
      return curve_;
    }
    record(*next);
    if (next->a.norm() > options_.greatest_norm) {
      curve_.end = CurveEnd::far;
      return curve_;
    }
    at = *next;
    direction = onwards;
    step = std::min(options_.greatest_step, step * kGrowth);
  }
  curve_.end = CurveEnd::long_way;
  return curve_;
}

}  // namespace

const CurvePoint& Curve::furthest() const {
  return *std::ranges::max_element(points, {}, &CurvePoint::t);
}

Curve follow(const Family& family, const Eigen::VectorXd& start, const ArclengthOptions& options) {
  return Follower(family, options).from(start);
}

}  // namespace fpkcheck::epc
