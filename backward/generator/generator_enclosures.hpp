#pragma once

#include <array>
#include <span>
#include <vector>

#include "backward/generator/impulse_mean_table.hpp"
#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Enclosures of the three factors in v of the generator L, applied to a product of splines A(y)
/// B(v),
///
///     L (A B) = A(y) (lambda (K B - B) - c v B') + A'(y) v B + (k y + mu y^3) A(y) (-B').
///
/// On every piece of the velocity axis each factor in v of the generator is a polynomial with
/// enclosed Bernstein coefficients. The slope of a spline sum_l c_l B_l is written with partial
/// sums S_l = B_l + B_{l+1} + .. over the splines of a piece, where S_0 = 1:
///
///     sum_l c_l B_l' = sum_{l>0} (c_l - c_{l-1}) S_l'.
///
/// On small spline cells neighbouring coefficients are nearly equal, and the sum over the slopes
/// S_l' of partial sums keeps the rounding error small relative to the differences of coefficients.
struct GeneratorVelocityFactorEnclosures {
  std::vector<VelocityAxisPiece> pieces;
  /// Indices of the splines B_b of the velocity that are nonzero on each piece of the velocity axis
  std::vector<std::vector<int>> function_indices;
  /// Factor lambda (K B - B) - c v B' of A(y) in the generator L. The remainder bound of the table
  /// of means applies to the impulse term lambda K B.
  PostImpulseMeanTable impulse_and_damping;
  /// Factor v B of A'(y) in the generator L, shape (pieces, functions of the piece)
  std::vector<std::vector<numerics::BernsteinCoefficients>> transport;
  /// Factor -S_l' of (k y + mu y^3) A for l > 0, shape (pieces, degree)
  std::vector<std::vector<numerics::BernsteinCoefficients>> restoring_force;

  /// Returns the number of Bernstein coefficients of each polynomial factor, its degree + 1.
  int coefficient_count() const { return impulse_and_damping.coefficient_count; }
};

/// Computes enclosures of the factors in v of the generator on the pieces that the impulse law
/// requires (velocity_piece_constraints()).
/// @param cuts additional ends of pieces, increasing
/// @pre inside call_with_upward_rounding
GeneratorVelocityFactorEnclosures enclose_velocity_factors(const problem::Problem& problem,
                                                           const ImpactSplineBasis& basis,
                                                           std::span<const double> cuts);

/// Enclosures of the three factors in y of the generator L, whose formula is at
/// GeneratorVelocityFactorEnclosures. On every piece of the displacement axis each factor in y of
/// the generator is a polynomial of degree p + 3 with enclosed Bernstein coefficients, where p is
/// the degree of the splines.
struct GeneratorDisplacementFactorEnclosures {
  /// Segment [begin, end] of the displacement axis within one knot span of the splines of y.
  struct Piece {
    int knot_span;
    double begin, end;
  };
  std::vector<Piece> pieces;
  /// The factors A, S' (slopes of partial sums) and (k y + mu y^3) A of the generator for the
  /// splines A(y) of each piece of the y axis, shape (pieces, 3, degree + 1); S' has only `degree`
  /// functions
  std::vector<std::array<std::vector<numerics::BernsteinCoefficients>, 3>> factors;
};

/// Computes enclosures of the factors in y of the generator on the knot spans of the splines of y.
/// @param cuts additional ends of pieces, increasing
/// @pre inside call_with_upward_rounding
GeneratorDisplacementFactorEnclosures enclose_displacement_factors(
    const problem::Problem& problem, const numerics::SplineBasis& basis,
    std::span<const double> cuts);

}  // namespace fpkcheck::backward
