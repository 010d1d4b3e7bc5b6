#pragma once

#include <Eigen/Core>

#include "dual/backward/displacement_operators.hpp"
#include "dual/backward/velocity_operators.hpp"
#include "dual/bounds/functional.hpp"
#include "dual/bounds/grid.hpp"
#include "dual/bounds/weight.hpp"

namespace fpkcheck::dual {

/// V = sum c_{ab} A_a(y) B_b(v) and U: what is claimed to solve L V = U - f.
struct Candidate {
  const Eigen::MatrixXd& coefficients;
  double mean;
};

struct CheckSetting {
  const problem::Problem& problem;
  const SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementOperators& y;
  const VelocityOperators& v;
  const Weight& weight;
  Ends ends = {};
};

}  // namespace fpkcheck::dual
