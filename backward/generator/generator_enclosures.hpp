#pragma once

#include <array>
#include <span>
#include <vector>

#include "backward/generator/impulse_mean_table.hpp"
#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Three factors in v of the generator on a product of splines A(y) B(v),
///
///     L (A B) = A(y) (lambda (K B - B) - c v B') + A'(y) v B + (k y + mu y^3) A(y) (-B'),
///
/// as enclosed Bernstein coefficients on every piece. Differences of coefficients c_l express the
/// derivative of a spline: sum_l c_l B_l' = sum_{l>0} (c_l - c_{l-1}) S_l'. The partial sum S_l =
/// B_l + B_{l+1} + .. contains the functions of a piece, and S_0 = 1. On small cells neighbouring
/// coefficients are nearly equal, and the sum over S_l' keeps the rounding error small relative to
/// the differences of coefficients.
struct VelocityFactorEnclosures {
  std::vector<VelocityPiece> pieces;
  std::vector<std::vector<int>> index;  ///< indices of the nonzero basis functions on each piece
  /// Factor lambda (K B - B) - c v B' of the spline A(y); the remainder of the table includes the
  /// factor lambda
  ImpulseMeanTable jump;
  /// Factor v B of A', shape (pieces, functions of the piece)
  std::vector<std::vector<numerics::BernsteinCoefficients>> drift;
  /// Factor -S_l' of (k y + mu y^3) A for l > 0, shape (pieces, degree)
  std::vector<std::vector<numerics::BernsteinCoefficients>> force;

  int order() const { return jump.order; }
};

/// @param cuts additional ends of pieces, increasing
/// @pre inside call_with_upward_rounding
VelocityFactorEnclosures enclose_velocity_factors(const problem::Problem& problem,
                                                  const ImpactBasis& basis,
                                                  std::span<const double> cuts);

/// Enclosures of the three factors in y of the generator, defined at VelocityFactorEnclosures, as
/// Bernstein coefficients of degree p + 3 on every piece of the displacement axis.
struct DisplacementFactorEnclosures {
  struct Piece {
    int span;
    double from, to;
  };
  std::vector<Piece> pieces;
  /// The three factors A, S' (partial_sum_slopes()) and (k y + mu y^3) A for the functions of each
  /// piece, shape (pieces, 3, degree + 1); S' has only `degree` functions
  std::vector<std::array<std::vector<numerics::BernsteinCoefficients>, 3>> factors;
};

/// @param cuts additional ends of pieces, increasing
DisplacementFactorEnclosures enclose_displacement_factors(const problem::Problem& problem,
                                                          const numerics::SplineBasis& basis,
                                                          std::span<const double> cuts);

}  // namespace fpkcheck::backward
