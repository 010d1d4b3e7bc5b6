#pragma once

#include <Eigen/Core>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/grid.hpp"
#include "backward/bounds/weight.hpp"
#include "backward/generator/displacement_operators.hpp"
#include "backward/generator/velocity_operators.hpp"

namespace fpkcheck::backward {

/// The certificate of a bound: V = sum c_{ab} A_a(y) B_b(v) and U, an approximate solution of
/// L V = U - f.
struct Certificate {
  const Eigen::MatrixXd& coefficients;
  double mean;
};

/// Context of the checks of a certificate: problem, bases, enclosed generator, weight, box ends.
struct CertificateContext {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementOperators& y;
  const VelocityOperators& v;
  const Weight& weight;
  BoxEnds ends = {};
};

}  // namespace fpkcheck::backward
