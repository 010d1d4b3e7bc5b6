#pragma once

#include <vector>

#include "backward/generator/impulse_table.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// The generator on A(y) B(v), a product of splines, is
///
///     L (A B) = A(y) (lambda (K B - B) - c v B') + A'(y) v B + (k y + mu y^3) A(y) (-B').
///
/// Here are the three factors in v, on every piece, with enclosed Bernstein coefficients.
/// Derivatives are those of differences: with the functions l of a piece and S_l = B_l + B_{l+1} +
/// .., whose first is 1, sum_l c_l B_l' = sum_{l>0} (c_l - c_{l-1}) S_l'. On small cells the
/// coefficients hardly differ, and their differences carry no more than their own rounding.
struct VelocityOperators {
  std::vector<VelocityPiece> pieces;
  std::vector<std::vector<int>> index;  ///< the functions that do not vanish on a piece
  ImpulseTable jump;                    ///< lambda (K B - B) - c v B', with lambda remainder
  std::vector<std::vector<numerics::BernsteinCoefficients>>
      drift;  ///< v B, shape (pieces, functions of the piece)
  std::vector<std::vector<numerics::BernsteinCoefficients>>
      force;  ///< -S_l', l > 0, shape (pieces, degree)

  int order() const { return jump.order; }
};

/// @param cuts further points, increasing, at which pieces are to end
/// @pre inside rounded_upward
VelocityOperators velocity_operators(const problem::Problem& problem, const ImpactBasis& basis,
                                     std::span<const double> cuts);

}  // namespace fpkcheck::backward
