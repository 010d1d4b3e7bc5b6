#include "epc/moment/homotopy.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace fpkcheck::epc::moment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kFirstStep = 0.2;  // in coefficients of functions of about unit variance
constexpr double kLongestStep = 1;
constexpr double kLeastStep = 1e-5;
constexpr int kMostSteps = 120;
constexpr int kCorrections = 6;
constexpr double kOnPath = 1e-6;  // length of a correction that is small enough to go on
constexpr double kLostBehind = -1;

// A point (a, t) of the path, as one vector.
struct Path {
  const Galerkin& equations;
  VectorXd initial;  // R(start)

  Index size() const { return equations.size(); }

  // [dH/da dH/dt] of H(a, t) = R(a) - (1 - t) R(start), with a row below.
  std::optional<Eigen::PartialPivLU<MatrixXd>> bordered(const Galerkin::Density& density,
                                                        const VectorXd& row) const {
    MatrixXd matrix(size() + 1, size() + 1);
    matrix.topLeftCorner(size(), size()) = equations.jacobian(density);
    matrix.topRightCorner(size(), 1) = initial;
    matrix.bottomRows(1) = row.transpose();
    if (!matrix.allFinite()) return std::nullopt;
    return matrix.partialPivLu();
  }

  // The tangent of unit length on the side of the direction given.
  std::optional<VectorXd> tangent(const VectorXd& point, const VectorXd& direction) const {
    const auto density = equations.density(point.head(size()));
    if (!density.finite) return std::nullopt;
    const auto factors = bordered(density, direction);
    if (!factors) return std::nullopt;
    const VectorXd t = factors->solve(VectorXd::Unit(size() + 1, size()));
    if (!t.allFinite() || t.norm() == 0) return std::nullopt;
    return t.normalized();
  }

  // Back to the path from a predicted point, normal to the tangent.
  std::optional<VectorXd> correct(VectorXd point, const VectorXd& tangent) const {
    for (int i = 0; i < kCorrections; ++i) {
      const auto density = equations.density(point.head(size()));
      if (!density.finite) return std::nullopt;
      const auto factors = bordered(density, tangent);
      if (!factors) return std::nullopt;
      VectorXd defect(size() + 1);
      defect << equations.residual(density) - (1 - point[size()]) * initial, 0;
      const VectorXd step = factors->solve(defect);
      if (!step.allFinite()) return std::nullopt;
      point -= step;
      if (step.norm() < kOnPath) return point;
    }
    return std::nullopt;
  }
};

}  // namespace

HomotopyResult follow_homotopy(const Galerkin& equations, const VectorXd& start) {
  HomotopyResult result{start, 0, 0, 0};
  const auto density = equations.density(start);
  if (!density.finite) return result;
  const Path path{equations, equations.residual(density)};
  const Index last = path.size();
  VectorXd point(last + 1);
  point << start, 0;
  auto tangent = path.tangent(point, VectorXd::Unit(last + 1, last));
  double step = kFirstStep;
  while (tangent && result.steps < kMostSteps && step > kLeastStep) {
    ++result.steps;
    const VectorXd predicted = point + step * *tangent;
    const auto next = path.correct(predicted, *tangent);
    if (!next || (*next - predicted).norm() > step) {
      step /= 2;
      continue;
    }
    const VectorXd before = point;
    point = *next;
    if (point[last] >= 1) {
      const double share = (1 - before[last]) / (point[last] - before[last]);
      result.a = (before + share * (point - before)).head(last);
      result.reached = 1;
      return result;
    }
    if (point[last] > result.reached) {
      result.reached = point[last];
      result.a = point.head(last);
    }
    if (point[last] < kLostBehind) break;
    const double direction = (*tangent)[last];
    tangent = path.tangent(point, *tangent);
    if (tangent && direction > 0 && (*tangent)[last] < 0) ++result.turns;
    step = std::min(1.5 * step, kLongestStep);
  }
  return result;
}

}  // namespace fpkcheck::epc::moment
