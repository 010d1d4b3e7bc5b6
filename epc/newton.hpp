#pragma once

#include <Eigen/Dense>

#include "epc/projection.hpp"

namespace fpkcheck::epc {

struct NewtonOptions {
  double tolerance = 1e-10;  ///< on max |R_s| relative to residual_unit
  int max_iterations = 30;
  /// Steps are halved until the residual falls (Armijo), and the iteration ends where no step along
  /// Newton's direction makes it fall.
  bool damped = false;
};

/// How an iteration ended; not reaching a root is a result.
struct NewtonResult {
  Eigen::VectorXd a;    ///< the root, or the iterate of the smallest residual
  double residual = 0;  ///< max |R_s(a)| relative to residual_unit
  int iterations = 0;
  bool converged = false;
};

/// The measure of residuals: the damping c, a term of F as it stands, but at least 1e-4 of the
/// frequency sigma_2/sigma_1 of the transport terms, whose rounding would show in less.
double residual_unit(const Projection& projection, const ResidualCoefficients& f);

/// The conventional Newton-Raphson method of the paper for (23), with the analytic Jacobian. One
/// step is added after convergence, which takes the root to rounding.
NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                    const Eigen::VectorXd& start, const NewtonOptions& options);

}  // namespace fpkcheck::epc
