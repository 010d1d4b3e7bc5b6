#pragma once

#include <array>
#include <span>
#include <vector>

#include "backward/generator/impulse_table.hpp"
#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// The three factors in v of the generator on a product of splines A(y) B(v),
///
///     L (A B) = A(y) (lambda (K B - B) - c v B') + A'(y) v B + (k y + mu y^3) A(y) (-B').
///
/// as enclosed Bernstein coefficients on every piece. The derivative of a spline with the
/// coefficients c_l is expressed by differences of coefficients, sum_l c_l B_l' = sum_{l>0} (c_l -
/// c_{l-1}) S_l', where S_l = B_l + B_{l+1} + .. is a sum over the functions of a piece and S_0 =
/// 1. On small cells neighbouring coefficients are nearly equal. The sum of the derivatives S_l'
/// keeps the rounding error small relative to the differences of coefficients.
struct VelocityOperators {
  std::vector<VelocityPiece> pieces;
  std::vector<std::vector<int>> index;  ///< for each piece, the functions that do not vanish there
  /// Factor lambda (K B - B) - c v B' of the spline A(y). The remainder of this table includes the
  /// factor lambda.
  ImpulseTable jump;
  /// Factor v B of A', shape (pieces, functions of the piece).
  std::vector<std::vector<numerics::BernsteinCoefficients>> drift;
  /// Factor -S_l' of (k y + mu y^3) A for l > 0, shape (pieces, degree).
  std::vector<std::vector<numerics::BernsteinCoefficients>> force;

  int order() const { return jump.order; }
};

/// @param cuts additional ends of pieces, increasing
/// @pre inside call_with_upward_rounding
VelocityOperators velocity_operators(const problem::Problem& problem, const ImpactBasis& basis,
                                     std::span<const double> cuts);

/// Enclosures of the three factors in y of the generator (VelocityOperators) on every piece of the
/// displacement axis, as Bernstein coefficients of degree p + 3.
struct DisplacementOperators {
  struct Piece {
    int span;
    double from, to;
  };
  std::vector<Piece> pieces;
  /// The three factors A, S' (partial_sum_slopes()) and (k y + mu y^3) A for the functions of
  /// each piece. The shape is (pieces, 3, degree + 1); S' has `degree` functions only.
  std::vector<std::array<std::vector<numerics::BernsteinCoefficients>, 3>> factors;
};

/// @param cuts additional ends of pieces, increasing
DisplacementOperators displacement_operators(const problem::Problem& problem,
                                             const numerics::SplineBasis& basis,
                                             std::span<const double> cuts);

}  // namespace fpkcheck::backward
