#pragma once

#include "epc/newton.hpp"

namespace fpkcheck::epc {

/// How far the branch of solutions could be followed.
struct Branch {
  Eigen::VectorXd a;    ///< the solution at `reached`
  double residual = 0;  ///< max |R_s(a)| / c there
  double reached = 0;   ///< fraction of the path; 1 when the whole problem is solved
  int iterations = 0;   ///< Newton steps in all
};

/// Follows the solution of (23) along the path of `partway`: from the exact density of white noise
/// at an impact without loss to the full problem. Steps are halved until Newton's method holds on
/// to the branch; where they shrink to nothing the branch turns back (its Jacobian is singular
/// there).
Branch follow_branch(const Projection& projection, const ResidualCoefficients& full,
                     double tolerance);

}  // namespace fpkcheck::epc
