#pragma once

#include <Eigen/Core>
#include <utility>

#include "backward/bounds/functional.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "backward/generator/generator_enclosures.hpp"

namespace fpkcheck::backward {

/// Certificate V of a bound (docs/bounds.md): an approximate solution of L V = U - f. The
/// coefficients c_{ab} define V = sum c_{ab} A_a(y) B_b(v); the member `mean` is the constant U.
struct Certificate {
  const Eigen::MatrixXd& coefficients;
  double mean;
};

/// Inputs of the checks of a certificate: problem, spline bases, enclosed factors of the generator,
/// weight tau, and kinds of the ends of the box.
struct CertificateCheckInputs {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementFactorEnclosures& y;
  const VelocityFactorEnclosures& v;
  const ResidualWeight& weight;
  BoxEndTypes ends = {};
};

/// Returns an upper bound of the weighted residual |f + L V - U| / tau outside the box of the
/// splines. Beyond the ends of an axis the certificate V is constant along the axis
/// (docs/bounds.md, "Outside the box").
/// @pre inside call_with_upward_rounding
double outer_residual_bound(const CertificateCheckInputs& context, const Functional& functional,
                            const Certificate& certificate);

struct ResidualRange {
  double least = 0, largest = 0;  ///< the residual range satisfies least <= 0 <= largest
  /// Whether the bisection reached the tolerance; otherwise the range is valid but not narrow
  bool is_converged = true;
  long boxes = 0;
};

/// Encloses the range of the weighted residual (f + L V - U) / tau over the box of the splines. On
/// each product of a y piece and a v piece, the Bernstein coefficients of the residual bound the
/// residual. Division by the least weight tau gives the range. The bisection stops when the bounds
/// of the range differ from attained values by less than the relative tolerance.
/// @param expected_range (least, largest) values that are probably attained. Good values reduce the
/// number of bisections; the range is valid for any values
/// @pre inside call_with_upward_rounding
ResidualRange residual_range(const CertificateCheckInputs& context, const Functional& functional,
                             const Certificate& certificate,
                             std::pair<double, double> expected_range, double tolerance);

}  // namespace fpkcheck::backward
