#include "epc/half_plane/norms.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "numerics/linear_algebra/dense_decompositions.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::epc::half_plane {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double rate_of_change_unit(const problem::Problem& problem) {
  constexpr double kRounding = 1e-4;
  const double frequency = std::sqrt(problem::equivalent_linearisation(problem).stiffness);
  return std::max(problem.system.damping(), kRounding * frequency);
}

double residual_norm(const VectorXd& residual, const MatrixXd& covariance, double unit) {
  const Eigen::LLT<MatrixXd> factors(covariance);
  if (factors.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  return factors.matrixL().solve(residual).norm() / unit;
}

double condition_number(const MatrixXd& jacobian, const MatrixXd& covariance) {
  const Eigen::LLT<MatrixXd> factors(covariance);
  MatrixXd scaled = factors.matrixL().solve(jacobian);
  scaled = factors.matrixL().solve(scaled.transpose().eval());
  const VectorXd values = numerics::singular_values(scaled);
  return values[0] / values[values.size() - 1];
}

double step_norm(const VectorXd& step, const MatrixXd& covariance) {
  return std::sqrt(step.dot(covariance * step));
}

}  // namespace fpkcheck::epc::half_plane
