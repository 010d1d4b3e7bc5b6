#pragma once

#include <Eigen/Core>
#include <utility>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "backward/generator/generator_enclosures.hpp"

namespace fpkcheck::backward {

/// Certificate V(y, v) of a bound (docs/bounds.md): an approximate solution of the backward
/// equation L V = U - f for the integrand f of a functional,
///
///     V = sum_ab c_ab A_a(y) B_b(v).
struct BoundCertificate {
  /// Coefficients c_ab, shape (functions of y, functions of v)
  const Eigen::MatrixXd& spline_coefficients;
  double approximate_mean;  ///< the constant U, an approximation of the mean E[f]
};

/// Inputs of the residual bounds of a certificate. The box of the splines is the rectangle of the
/// phase plane between the end knots of both bases.
struct ResidualBoundInputs {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement_basis;  ///< splines A_a of y
  const ImpactSplineBasis& velocity_basis;          ///< splines B_b of v
  /// Enclosures of the factors of the generator L
  const GeneratorDisplacementFactorEnclosures& displacement_factors;
  const GeneratorVelocityFactorEnclosures& velocity_factors;
  const ResidualWeightFunctionOfEnergy& residual_weight;  ///< weight tau
  DisplacementBoundaryTypes displacement_ends = {};       ///< types of the two ends of the box in y
};

/// Returns an upper bound of the weighted residual |f + L V - U| / tau outside the box of the
/// splines. Beyond the ends of an axis the certificate V is constant along the axis
/// (docs/bounds.md, "Outside the box").
/// @pre inside call_with_upward_rounding
double outer_residual_bound(const ResidualBoundInputs& inputs,
                            const StationaryFunctional& functional,
                            const BoundCertificate& certificate);

/// Guaranteed range of the weighted residual inside the box: least <= (f + L V - U) / tau <=
/// largest.
struct BackwardResidualRange {
  double least = 0, largest = 0;  ///< bounds of the range, with least <= 0 <= largest
  /// Whether the bisection reached the tolerance; otherwise the range is valid but not narrow
  bool is_converged = true;
  long box_count = 0;  ///< number of sub-boxes in the bisection
};

/// Encloses the range of the weighted residual (f + L V - U) / tau over the box of the splines. On
/// the product of a piece of the y axis and a piece of the v axis the residual is a polynomial, and
/// the residual lies between its smallest and its largest Bernstein coefficient. Division by the
/// least weight tau on the product gives bounds of the weighted residual. The bisection of a
/// product stops when the bounds differ from attained values by less than the relative tolerance.
/// @param expected_range smallest and largest value that the weighted residual probably attains.
/// Accurate values reduce the number of bisections; the result is valid for any values
/// @pre inside call_with_upward_rounding
BackwardResidualRange enclose_residual_range(const ResidualBoundInputs& inputs,
                                             const StationaryFunctional& functional,
                                             const BoundCertificate& certificate,
                                             std::pair<double, double> expected_range,
                                             double tolerance);

}  // namespace fpkcheck::backward
