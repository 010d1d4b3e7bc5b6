#include "epc/newton.hpp"

#include <cmath>

namespace fpkcheck::epc {
namespace {

// F contains the damping as a term of its own, which makes it the measure of the others.
double size_of(const Eigen::VectorXd& residual, const ResidualCoefficients& f) {
  return residual.lpNorm<Eigen::Infinity>() / f.damping;
}

}  // namespace

NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                    const Eigen::VectorXd& start, const NewtonOptions& options) {
  Eigen::VectorXd a = start;
  Eigen::VectorXd residual = projection.residual(f, a);
  const double at_start = size_of(residual, f);
  NewtonResult best{a, at_start, 0, at_start < options.tolerance};
  while (best.iterations < options.max_iterations) {
    const bool polishing = best.converged;
    a -= projection.jacobian(f, a).partialPivLu().solve(residual);
    residual = projection.residual(f, a);
    const double size = size_of(residual, f);
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
