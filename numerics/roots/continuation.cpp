#include "numerics/roots/continuation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "numerics/linear_algebra/factorisations.hpp"

namespace fpkcheck::numerics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMaxCorrections = 6;
constexpr int kFoldBisections = 40;

class SolutionCurveTracer {
 public:
  SolutionCurveTracer(const Homotopy& homotopy, const ContinuationOptions& options)
      : homotopy_(homotopy), options_(options) {}

  SolutionCurve trace_from(const VectorXd& start);

 private:
  MatrixXd bordered_jacobian(const SolutionCurvePoint& point, const VectorXd& last_row) const;
  VectorXd unit_tangent(const SolutionCurvePoint& point, const VectorXd& previous_tangent) const;
  bool is_converged(const VectorXd& residual, double correction) const;
  std::optional<SolutionCurvePoint> correct_prediction(const SolutionCurvePoint& predicted,
                                                       const VectorXd& tangent, double step);
  std::optional<SolutionCurvePoint> correct_at_fixed_t(SolutionCurvePoint point);
  std::optional<SolutionCurvePoint> point_at_parameter_limit(const SolutionCurvePoint& before,
                                                             const SolutionCurvePoint& beyond);
  SolutionCurvePoint locate_fold(const SolutionCurvePoint& from, const VectorXd& tangent,
                                 double step);
  void append_point(const SolutionCurvePoint& point) { curve_.points.push_back(point); }
  void append_fold(const SolutionCurvePoint& at, const VectorXd& direction, double step);

  const Homotopy& homotopy_;
  const ContinuationOptions& options_;
  SolutionCurve curve_;
};

SolutionCurvePoint predict_point(const SolutionCurvePoint& from, const VectorXd& tangent,
                                 double step) {
  const Index n = from.a.size();
  return {from.a + step * tangent.head(n), from.t + step * tangent[n]};
}

// Returns the matrix of the derivatives [dG/da dG/dt] of the homotopy G(a, t), with `last_row` as
// additional last row.
MatrixXd SolutionCurveTracer::bordered_jacobian(const SolutionCurvePoint& point,
                                                const VectorXd& last_row) const {
  const Index n = point.a.size();
  MatrixXd matrix(n + 1, n + 1);
  matrix.topLeftCorner(n, n) = homotopy_.jacobian(point.a, point.t);
  matrix.col(n).head(n) = homotopy_.parameter_derivative(point.a, point.t);
  matrix.row(n) = last_row.transpose();
  return matrix;
}

// Returns the unit tangent of the solution curve that has a positive scalar product with the
// previous tangent.
VectorXd SolutionCurveTracer::unit_tangent(const SolutionCurvePoint& point,
                                           const VectorXd& previous_tangent) const {
  const Index n = point.a.size();
  return LuFactors(bordered_jacobian(point, previous_tangent))
      .solve(VectorXd::Unit(n + 1, n))
      .normalized();
}

bool SolutionCurveTracer::is_converged(const VectorXd& residual, double correction) const {
  return residual.lpNorm<Eigen::Infinity>() < options_.tolerance ||
         correction < options_.correction_tolerance;
}

// Corrects a predicted point of the solution curve by Newton steps within the hyperplane through
// `start` that is normal to the tangent.
std::optional<SolutionCurvePoint> SolutionCurveTracer::correct_prediction(
    const SolutionCurvePoint& start, const VectorXd& tangent, double step) {
  const Index n = start.a.size();
  SolutionCurvePoint point = start;
  VectorXd residual = homotopy_.residual(point.a, point.t);
  for (int i = 0; i < kMaxCorrections && residual.allFinite(); ++i) {
    VectorXd right(n + 1);
    right << -residual, 0;
    const VectorXd change = LuFactors(bordered_jacobian(point, tangent)).solve(right);
    point.a += change.head(n);
    point.t += change[n];
    ++curve_.iterations;
    residual = homotopy_.residual(point.a, point.t);
    if (residual.allFinite() && is_converged(residual, change.norm())) {
      const double displacement = std::hypot((point.a - start.a).norm(), point.t - start.t);
      return displacement < options_.max_relative_correction * std::abs(step) ? std::optional(point)
                                                                              : std::nullopt;
    }
  }
  return std::nullopt;
}

std::optional<SolutionCurvePoint> SolutionCurveTracer::correct_at_fixed_t(
    SolutionCurvePoint point) {
  VectorXd residual = homotopy_.residual(point.a, point.t);
  for (int i = 0; i < kMaxCorrections && residual.allFinite(); ++i) {
    const VectorXd change = LuFactors(homotopy_.jacobian(point.a, point.t)).solve(residual);
    point.a -= change;
    ++curve_.iterations;
    residual = homotopy_.residual(point.a, point.t);
    if (residual.allFinite() && is_converged(residual, change.norm())) return point;
  }
  return std::nullopt;
}

// Returns the point of the solution curve at an end of the parameter interval, interpolated between
// a point inside the interval and a point beyond the end.
std::optional<SolutionCurvePoint> SolutionCurveTracer::point_at_parameter_limit(
    const SolutionCurvePoint& before, const SolutionCurvePoint& beyond) {
  const double end = beyond.t >= 1 ? 1 : options_.min_t;
  const double share = (end - before.t) / (beyond.t - before.t);
  const SolutionCurvePoint between{before.a + share * (beyond.a - before.a), end};
  return options_.correct_end_point ? correct_at_fixed_t(between) : between;
}

// Locates a fold of the solution curve, a point with stationary t, by bisection of the step length.
SolutionCurvePoint SolutionCurveTracer::locate_fold(const SolutionCurvePoint& from,
                                                    const VectorXd& tangent_there, double step) {
  const Index n = from.a.size();
  double low = 0, high = step;
  SolutionCurvePoint fold = from;
  for (int i = 0; i < kFoldBisections; ++i) {
    const double middle = (low + high) / 2;
    const auto point =
        correct_prediction(predict_point(from, tangent_there, middle), tangent_there, step);
    if (!point) break;
    fold = *point;
    (unit_tangent(fold, tangent_there)[n] * tangent_there[n] > 0 ? low : high) = middle;
  }
  return fold;
}

void SolutionCurveTracer::append_fold(const SolutionCurvePoint& at, const VectorXd& direction,
                                      double step) {
  append_point(locate_fold(at, direction, step));
  curve_.folds.push_back(curve_.points.size() - 1);
}

SolutionCurve SolutionCurveTracer::trace_from(const VectorXd& start) {
  const Index n = start.size();
  SolutionCurvePoint at{start, 0};
  VectorXd direction = unit_tangent(at, VectorXd::Unit(n + 1, n));
  append_point(at);
  double step = options_.first_step;
  for (int left = options_.max_points; left > 0; --left) {
    if (options_.should_stop && options_.should_stop()) break;
    const auto next = correct_prediction(predict_point(at, direction, step), direction, step);
    const bool beyond = next && (next->t >= 1 || next->t <= options_.min_t);
    const auto last = beyond ? point_at_parameter_limit(at, *next) : next;
    if (!last) {
      step /= 2;
      if (step < options_.min_step) return std::move(curve_);
      continue;
    }
    const VectorXd onwards = unit_tangent(*next, direction);
    if (options_.locate_folds && onwards[n] * direction[n] < 0) append_fold(at, direction, step);
    append_point(*last);
    if (beyond) {
      curve_.end =
          last->t == 1 ? ContinuationTermination::end_reached : ContinuationTermination::fell_back;
      return std::move(curve_);
    }
    if (next->a.norm() > options_.max_norm) {
      curve_.end = ContinuationTermination::diverged;
      return std::move(curve_);
    }
    at = *next;
    direction = onwards;
    step = std::min(options_.max_step, step * options_.step_growth);
  }
  curve_.end = ContinuationTermination::limit_exceeded;
  return std::move(curve_);
}

}  // namespace

Homotopy newton_homotopy(std::function<VectorXd(const VectorXd&)> residual,
                         std::function<MatrixXd(const VectorXd&)> jacobian, const VectorXd& start) {
  const VectorXd initial = residual(start);
  return {.residual = [residual = std::move(residual), initial](const VectorXd& a, double t)
              -> VectorXd { return residual(a) - (1 - t) * initial; },
          .jacobian = [jacobian = std::move(jacobian)](const VectorXd& a,
                                                       double) { return jacobian(a); },
          .parameter_derivative = [initial](const VectorXd&, double) { return initial; }};
}

const SolutionCurvePoint& SolutionCurve::curve_point_with_largest_parameter() const {
  return *std::ranges::max_element(points, {}, &SolutionCurvePoint::t);
}

SolutionCurve trace_solution_curve(const Homotopy& homotopy, const VectorXd& start,
                                   const ContinuationOptions& options) {
  return SolutionCurveTracer(homotopy, options).trace_from(start);
}

}  // namespace fpkcheck::numerics
