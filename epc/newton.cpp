#include "epc/newton.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::epc {
namespace {

constexpr double kLeastStep = 1e-4;
constexpr double kArmijo = 0.1;

// How far to go along the step from a: all of it, or the first half, quarter, ... of it after which
// the residual has fallen. Zero when there is none.
double damping_of(const Projection& projection, const ResidualCoefficients& f,
                  const Eigen::VectorXd& a, const Eigen::VectorXd& step, double before) {
  for (double share = 1; share > kLeastStep; share /= 2) {
    const double after = projection.residual(f, a - share * step).norm();
    if (after < (1 - kArmijo * share) * before) return share;
  }
  return 0;
}

}  // namespace

double residual_unit(const Projection& projection, const ResidualCoefficients& f) {
  constexpr double kRounding = 1e-4;
  const Deviations& sigma = projection.basis().sigma();
  return std::max(f.damping, kRounding * sigma.x2 / sigma.x1);
}

NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                    const Eigen::VectorXd& start, const NewtonOptions& options) {
  const double unit = residual_unit(projection, f);
  const auto size_of = [&](const Eigen::VectorXd& residual) {
    return residual.lpNorm<Eigen::Infinity>() / unit;
  };
  Eigen::VectorXd a = start;
  Eigen::VectorXd residual = projection.residual(f, a);
  const double at_start = size_of(residual);
  NewtonResult best{a, at_start, 0, at_start < options.tolerance};
  while (best.iterations < options.max_iterations) {
    const bool polishing = best.converged;
    Eigen::VectorXd step = projection.jacobian(f, a).partialPivLu().solve(residual);
    if (options.damped && !polishing) {
      const double share = damping_of(projection, f, a, step, residual.norm());
      if (share == 0) break;
      step *= share;
    }
    a -= step;
    residual = projection.residual(f, a);
    const double size = size_of(residual);
    if (!std::isfinite(size)) break;
    ++best.iterations;
    if (size < best.residual) {
      best.a = a;
      best.residual = size;
      best.converged = size < options.tolerance;
    }
    if (polishing) break;
  }
  return best;
}

}  // namespace fpkcheck::epc
