#include "numerics/roots/arclength.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "numerics/linear_algebra/dense.hpp"

namespace fpkcheck::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kCorrections = 6;
constexpr int kFoldBisections = 40;

class Follower {
 public:
  Follower(const Family& family, const ArclengthOptions& options)
      : family_(family), options_(options) {}

  Curve from(const VectorXd& start);

 private:
  MatrixXd bordered(const CurvePoint& at, const VectorXd& last_row) const;
  VectorXd tangent(const CurvePoint& at, const VectorXd& before) const;
  bool on_curve(const VectorXd& residual, double correction) const;
  std::optional<CurvePoint> corrected(const CurvePoint& predicted, const VectorXd& tangent,
                                      double step);
  std::optional<CurvePoint> corrected_at(CurvePoint point);
  std::optional<CurvePoint> landed(const CurvePoint& before, const CurvePoint& beyond);
  CurvePoint fold_after(const CurvePoint& from, const VectorXd& tangent, double step);
  void record(const CurvePoint& at) { curve_.points.push_back(at); }
  void record_fold(const CurvePoint& at, const VectorXd& direction, double step);

  const Family& family_;
  const ArclengthOptions& options_;
  Curve curve_;
};

CurvePoint predicted(const CurvePoint& from, const VectorXd& tangent, double step) {
  const Index n = from.a.size();
  return {from.a + step * tangent.head(n), from.t + step * tangent[n]};
}

// The matrix [dG/da dG/dt] with one more row below.
MatrixXd Follower::bordered(const CurvePoint& at, const VectorXd& last_row) const {
  const Index n = at.a.size();
  MatrixXd matrix(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = family_.jacobian(at.a, at.t);
  matrix.col(n).head(n) = family_.rate(at.a, at.t);
  matrix.row(n) = last_row.transpose();
  return matrix;
}

// The unit tangent, oriented like the previous tangent.
VectorXd Follower::tangent(const CurvePoint& at, const VectorXd& before) const {
  const Index n = at.a.size();
  return Factors(bordered(at, before)).solve(VectorXd::Unit(n + 1, n)).normalized();
}

bool Follower::on_curve(const VectorXd& residual, double correction) const {
  return residual.lpNorm<Eigen::Infinity>() < options_.tolerance ||
         correction < options_.short_correction;
}

// Corrector: Newton steps in the plane through `start`, normal to the tangent.
std::optional<CurvePoint> Follower::corrected(const CurvePoint& start, const VectorXd& tangent,
                                              double step) {
  const Index n = start.a.size();
  CurvePoint point = start;
  VectorXd residual = family_.residual(point.a, point.t);
  for (int i = 0; i < kCorrections && residual.allFinite(); ++i) {
    VectorXd right(n + 1);
    right << -residual, 0;
    const VectorXd change = Factors(bordered(point, tangent)).solve(right);
    point.a += change.head(n);
    point.t += change[n];
    ++curve_.iterations;
    residual = family_.residual(point.a, point.t);
    if (residual.allFinite() && on_curve(residual, change.norm())) {
      const double strayed = std::hypot((point.a - start.a).norm(), point.t - start.t);
      return strayed < options_.leash * std::abs(step) ? std::optional(point) : std::nullopt;
    }
  }
  return std::nullopt;
}

// Newton steps at fixed t.
std::optional<CurvePoint> Follower::corrected_at(CurvePoint point) {
  VectorXd residual = family_.residual(point.a, point.t);
  for (int i = 0; i < kCorrections && residual.allFinite(); ++i) {
    const VectorXd change = Factors(family_.jacobian(point.a, point.t)).solve(residual);
    point.a -= change;
    ++curve_.iterations;
    residual = family_.residual(point.a, point.t);
    if (residual.allFinite() && on_curve(residual, change.norm())) return point;
  }
  return std::nullopt;
}

// The point at an end of the range of t, between a point inside and a point beyond the end.
std::optional<CurvePoint> Follower::landed(const CurvePoint& before, const CurvePoint& beyond) {
  const double end = beyond.t >= 1 ? 1 : options_.least_t;
  const double share = (end - before.t) / (beyond.t - before.t);
  const CurvePoint between{before.a + share * (beyond.a - before.a), end};
  return options_.correct_end ? corrected_at(between) : between;
}

// The fold, where t is stationary, between a point and the next step; by bisection of the step.
CurvePoint Follower::fold_after(const CurvePoint& from, const VectorXd& tangent_there,
                                double step) {
  const Index n = from.a.size();
  double low = 0, high = step;
  CurvePoint fold = from;
  for (int i = 0; i < kFoldBisections; ++i) {
    const double middle = (low + high) / 2;
    const auto point = corrected(predicted(from, tangent_there, middle), tangent_there, step);
    if (!point) break;
    fold = *point;
    (tangent(fold, tangent_there)[n] * tangent_there[n] > 0 ? low : high) = middle;
  }
  return fold;
}

void Follower::record_fold(const CurvePoint& at, const VectorXd& direction, double step) {
  record(fold_after(at, direction, step));
  curve_.folds.push_back(curve_.points.size() - 1);
}

Curve Follower::from(const VectorXd& start) {
  const Index n = start.size();
  CurvePoint at{start, 0};
  VectorXd direction = tangent(at, VectorXd::Unit(n + 1, n));
  record(at);
  double step = options_.first_step;
  for (int left = options_.max_points; left > 0; --left) {
    if (options_.give_up && options_.give_up()) break;
    const auto next = corrected(predicted(at, direction, step), direction, step);
    const bool beyond = next && (next->t >= 1 || next->t <= options_.least_t);
    const auto last = beyond ? landed(at, *next) : next;
    if (!last) {
      step /= 2;
      if (step < options_.least_step) return std::move(curve_);
      continue;
    }
    const VectorXd onwards = tangent(*next, direction);
    if (options_.locate_folds && onwards[n] * direction[n] < 0) record_fold(at, direction, step);
    record(*last);
    if (beyond) {
      curve_.end = last->t == 1 ? CurveEnd::arrived : CurveEnd::returned;
      return std::move(curve_);
    }
    if (next->a.norm() > options_.greatest_norm) {
      curve_.end = CurveEnd::far;
      return std::move(curve_);
    }
    at = *next;
    direction = onwards;
    step = std::min(options_.greatest_step, step * options_.growth);
  }
  curve_.end = CurveEnd::long_way;
  return std::move(curve_);
}

}  // namespace

Family newton_homotopy(std::function<VectorXd(const VectorXd&)> residual,
                       std::function<MatrixXd(const VectorXd&)> jacobian, const VectorXd& start) {
  const VectorXd initial = residual(start);
  return {.residual = [residual = std::move(residual), initial](const VectorXd& a, double t)
              -> VectorXd { return residual(a) - (1 - t) * initial; },
          .jacobian = [jacobian = std::move(jacobian)](const VectorXd& a,
                                                       double) { return jacobian(a); },
          .rate = [initial](const VectorXd&, double) { return initial; }};
}

const CurvePoint& Curve::furthest() const {
  return *std::ranges::max_element(points, {}, &CurvePoint::t);
}

Curve follow(const Family& family, const VectorXd& start, const ArclengthOptions& options) {
  return Follower(family, options).from(start);
}

}  // namespace fpkcheck::numerics
