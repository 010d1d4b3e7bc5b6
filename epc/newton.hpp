#pragma once

#include <Eigen/Dense>

#include "epc/projection.hpp"

namespace fpkcheck::epc {

struct NewtonOptions {
  double tolerance = 1e-10;  ///< on max |R_s| / c
  int max_iterations = 30;
};

/// How an iteration ended; not reaching a root is a result.
struct NewtonResult {
  Eigen::VectorXd a;    ///< the root, or the iterate of the smallest residual
  double residual = 0;  ///< max |R_s(a)| / c
  int iterations = 0;
  bool converged = false;
};

/// The conventional Newton-Raphson method of the paper for (23), with the analytic Jacobian. One
/// step is added after convergence, which takes the root to rounding.
NewtonResult newton(const Projection& projection, const ResidualCoefficients& f,
                    const Eigen::VectorXd& start, const NewtonOptions& options);

}  // namespace fpkcheck::epc
