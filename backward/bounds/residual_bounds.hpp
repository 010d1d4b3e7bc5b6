#pragma once

#include <Eigen/Core>
#include <utility>

#include "backward/bounds/bounded_expectation.hpp"
#include "backward/bounds/residual_weight.hpp"
#include "backward/bounds/spline_grid.hpp"
#include "backward/generator/generator_enclosures.hpp"

namespace fpkcheck::backward {

/// Certificate V(y, v) of a bound (docs/bounds.md): an approximate solution of the backward
/// equation L V = U - f for the integrand f of a functional, with the generator L,
///
///     V = sum_ab c_ab A_a(y) B_b(v).
struct BoundCertificate {
  /// Coefficients c_ab of the spline products of a certificate, as matrix: row for y, column for v
  const Eigen::MatrixXd& spline_coefficients;
  double approximate_mean;  ///< the constant U, an approximation of the mean E[f]
};

/// Problem, splines and weight from which bounds of the residual of a certificate are computed. The
/// box of the splines is the rectangle of the phase plane between the end knots of the splines.
struct ResidualBoundInputs {
  const problem::Problem& problem;
  const numerics::SplineBasis& displacement_basis;  ///< splines A_a of y
  const ImpactSplineBasis& velocity_basis;          ///< splines B_b of v
  /// Guaranteed enclosures of the factors in y and in v of the generator L
  const GeneratorDisplacementFactorEnclosures& displacement_factors;
  const GeneratorVelocityFactorEnclosures& velocity_factors;
  const ResidualWeightFunctionOfEnergy& residual_weight;  ///< weight tau
  DisplacementBoundaryTypes displacement_ends = {};       ///< types of the two ends of the box in y
};

/// Returns an upper bound of the weighted residual |f + L V - U| / tau of a certificate V outside
/// the box of the splines. Beyond the end knots of the splines of an axis the certificate V is
/// constant along this axis (docs/bounds.md, "Outside the box").
/// @pre inside call_with_upward_rounding
double outer_residual_bound(const ResidualBoundInputs& inputs,
                            const StationaryFunctional& functional,
                            const BoundCertificate& certificate);

/// Guaranteed range of the weighted residual of a certificate V inside the box of the splines:
/// least <= (f + L V - U) / tau <= largest.
struct BackwardResidualRange {
  double least = 0, largest = 0;  ///< bounds of the range, with least <= 0 <= largest
  /// Whether the bisection of the box reached its tolerance; otherwise the range of the residual is
  /// valid but not narrow
  bool is_converged = true;
  long box_count = 0;  ///< number of sub-boxes in the bisection
};

/// Encloses the range of the weighted residual (f + L V - U) / tau of a certificate V over the box
/// of the splines. On each rectangle of a knot span in y and a knot span in v the residual of a
/// certificate is a polynomial, whose values lie between its smallest and its largest Bernstein
/// coefficient. Division by the least weight tau on a rectangle gives bounds of the weighted
/// residual on this rectangle. The bisection of a rectangle stops when the bounds of the weighted
/// residual differ from attained values by less than the relative tolerance.
/// @param expected_range smallest and largest value that the weighted residual probably attains. An
/// accurate expected range reduces the number of bisections; the guaranteed range is valid for any
/// expected range.
/// @pre inside call_with_upward_rounding
BackwardResidualRange enclose_residual_range(const ResidualBoundInputs& inputs,
                                             const StationaryFunctional& functional,
                                             const BoundCertificate& certificate,
                                             std::pair<double, double> expected_range,
                                             double tolerance);

}  // namespace fpkcheck::backward
