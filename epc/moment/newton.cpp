#include "epc/moment/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::moment {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLongestStep = 2;
constexpr double kLeastFraction = 1e-6;

}  // namespace

double rate_unit(const problem::Problem& problem) {
  constexpr double kRounding = 1e-4;
  const double frequency = std::sqrt(problem::equivalent_linearisation(problem).stiffness);
  return std::max(problem.system.damping(), kRounding * frequency);
}

double size_of(const VectorXd& residual, const MatrixXd& covariance, double unit) {
  const Eigen::LLT<MatrixXd> factors(covariance);
  if (factors.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  return factors.matrixL().solve(residual).norm() / unit;
}

double condition_of(const MatrixXd& jacobian, const MatrixXd& covariance) {
  const Eigen::LLT<MatrixXd> factors(covariance);
  MatrixXd scaled = factors.matrixL().solve(jacobian);
  scaled = factors.matrixL().solve(scaled.transpose().eval());
  const VectorXd squares =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(scaled * scaled.transpose(), Eigen::EigenvaluesOnly)
          .eigenvalues();
  return std::sqrt(squares.maxCoeff() / squares.minCoeff());
}

double length(const VectorXd& step, const MatrixXd& covariance) {
  return std::sqrt(step.dot(covariance * step));
}

NewtonResult newton(const Galerkin& equations, const VectorXd& start, double unit,
                    const NewtonOptions& options) {
  NewtonResult best{start, std::numeric_limits<double>::infinity(), 0, false};
  VectorXd a = start;
  for (;;) {
    const Galerkin::Density density = equations.density(a);
    if (!density.finite) break;
    const VectorXd residual = equations.residual(density);
    const MatrixXd metric = equations.covariance(density);
    const double size = size_of(residual, metric, unit);
    if (!std::isfinite(size)) break;
    const bool polished = best.converged;
    if (size < best.residual) {
      best.a = a;
      best.residual = size;
      best.converged = size < options.tolerance;
    }
    if (polished || (best.converged && !options.polish)) break;
    if (best.iterations == options.max_iterations) break;

    const Eigen::PartialPivLU<MatrixXd> factors(equations.jacobian(density));
    const VectorXd step = -factors.solve(residual);
    const double step_length = length(step, metric);
    if (!std::isfinite(step_length)) break;
    double fraction = std::min(1.0, kLongestStep / step_length);
    const auto shortens = [&] {
      if (best.converged) return true;  // rounding alone is left
      const Galerkin::Density trial = equations.density(a + fraction * step);
      if (!trial.finite) return false;
      const VectorXd next = factors.solve(equations.residual(trial));
      return length(next, metric) <= (1 - fraction / 4) * step_length;
    };
    while (fraction > kLeastFraction && !shortens()) fraction /= 2;
    if (fraction <= kLeastFraction) break;
    a += fraction * step;
    ++best.iterations;
  }
  return best;
}

}  // namespace fpkcheck::epc::moment
