#pragma once

#include <Eigen/Core>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "backward/generator/displacement_operators.hpp"
#include "backward/generator/velocity_operators.hpp"

namespace fpkcheck::backward {

/// The certificate of a bound: an approximate solution of L V = U - f. The coefficients c_{ab} give
/// V = sum c_{ab} A_a(y) B_b(v), and the mean is U.
struct Certificate {
  const Eigen::MatrixXd& coefficients;
  double mean;
};

/// What the checks of a certificate need besides the certificate: the problem, the spline bases,
/// the enclosed factors of the generator, the weight tau and the kinds of the ends of the box.
struct CertificateCheckInputs {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementOperators& y;
  const VelocityOperators& v;
  const ResidualWeight& weight;
  BoxEnds ends = {};
};

}  // namespace fpkcheck::backward
