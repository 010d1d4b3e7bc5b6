#pragma once

#include <Eigen/Dense>

#include "epc/moment/galerkin.hpp"

namespace fpkcheck::epc::moment {

/// Where a homotopy led.
struct HomotopyResult {
  Eigen::VectorXd a;   ///< where the path met t = 1, else its point of the largest t
  double reached = 0;  ///< the largest t met; 1 when the path arrived
  int turns = 0;       ///< folds passed: how often t began to fall
  int steps = 0;
};

/// Newton's homotopy R(a) = (1 - t) R(start), from t = 0, where the start solves it, to t = 1,
/// followed by pseudo-arclength: predictor along the tangent, corrector in the hyperplane normal
/// to it, so that a fold in t is passed. It rescues starts from which damped Newton steps end at a
/// point where the Jacobian is singular. The end is to be refined by Newton's method.
HomotopyResult follow_homotopy(const Galerkin& equations, const Eigen::VectorXd& start);

}  // namespace fpkcheck::epc::moment
