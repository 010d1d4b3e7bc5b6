#include "epc/continuation.hpp"

#include <algorithm>

namespace fpkcheck::epc {
namespace {

constexpr double kFirstStep = 0.25;
constexpr double kLeastStep = 1e-4;
constexpr double kGrowth = 1.5;
// A corrected point further from the predicted one than this, in scaled unknowns of order one, may
// lie on another branch.
constexpr double kLeash = 0.3;
constexpr int kCorrections = 8;

// Q_n of the exact density, up to a constant: -(c/D2) (x2^2/2 + k x1^2/2 + mu x1^4/4).
std::vector<Term> elastic_white_noise(const ResidualCoefficients& f) {
  const double beta = f.damping / (f.rate_moment[2] / 2);
  return {{2, 0, -beta * f.stiffness / 2}, {0, 2, -beta / 2}, {4, 0, -beta * f.cubic / 4}};
}

}  // namespace

Branch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                     double tolerance) {
  const NewtonOptions options{.tolerance = tolerance, .max_iterations = kCorrections};
  const NewtonResult exact = newton(projection, partway(full, 0),
                                    projection.basis().scaled(elastic_white_noise(full)), options);
  Branch branch{exact.a, exact.residual, 0, exact.iterations};
  if (!exact.converged) return branch;

  Eigen::VectorXd tangent = Eigen::VectorXd::Zero(branch.a.size());  // da / d(fraction), by secants
  double step = kFirstStep;
  while (branch.reached < 1 && step > kLeastStep) {
    const double fraction = std::min(1.0, branch.reached + step);
    const Eigen::VectorXd predicted = branch.a + (fraction - branch.reached) * tangent;
    const NewtonResult corrected = newton(projection, partway(full, fraction), predicted, options);
    branch.iterations += corrected.iterations;
    if (!corrected.converged || (corrected.a - predicted).norm() > kLeash) {
      step /= 2;
      continue;
    }
    tangent = (corrected.a - branch.a) / (fraction - branch.reached);
    branch.a = corrected.a;
    branch.residual = corrected.residual;
    branch.reached = fraction;
    step *= kGrowth;
  }
  return branch;
}

}  // namespace fpkcheck::epc
