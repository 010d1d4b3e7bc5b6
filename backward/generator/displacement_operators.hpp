#pragma once

#include <array>
#include <span>
#include <vector>

#include "numerics/interval/bernstein.hpp"
#include "numerics/splines/spline_basis.hpp"
#include "problem/problem.hpp"

namespace fpkcheck::backward {

/// Enclosures of the three factors in y of the generator (VelocityOperators) on every piece of the
/// displacement axis, as Bernstein coefficients of degree p + 3.
struct DisplacementOperators {
  struct Piece {
    int span;
    double from, to;
  };
  std::vector<Piece> pieces;
  /// The three factors A, S' (partial_sum_slopes.hpp) and (k y + mu y^3) A for the functions of
  /// each piece. The shape is (pieces, 3, degree + 1); S' has `degree` functions only.
  std::vector<std::array<std::vector<numerics::BernsteinCoefficients>, 3>> factors;
};

/// @param cuts additional ends of pieces, increasing
DisplacementOperators displacement_operators(const problem::Problem& problem,
                                             const numerics::SplineBasis& basis,
                                             std::span<const double> cuts);

}  // namespace fpkcheck::backward
