#pragma once

#include <Eigen/Core>
#include <vector>

#include "dual/backward/velocity_operators.hpp"
#include "dual/bounds/functional.hpp"
#include "dual/bounds/weight.hpp"

namespace fpkcheck::dual {

/// What of the check does not depend on the functional: the three factors in y of the generator, on
/// every piece of the displacement axis, with enclosed Bernstein coefficients of degree p + 3.
struct DisplacementOperators {
  struct Piece {
    int span;
    double from, to;
  };
  std::vector<Piece> pieces;
  /// A, A' and (k y + mu y^3) A of the functions of a piece, shape (pieces, 3, functions).
  std::vector<std::array<std::vector<Coefficients>, 3>> factors;
};

/// @param cuts further points, increasing, at which pieces are to end
DisplacementOperators displacement_operators(const problem::Problem& problem,
                                             const SplineBasis& basis, std::span<const double> cuts);

/// V = sum c_{ab} A_a(y) B_b(v) and U: what is claimed to solve L V = U - f.
struct Candidate {
  const Eigen::MatrixXd& coefficients;
  double mean;
};

struct CheckSetting {
  const problem::Problem& problem;
  const SplineBasis& displacement;
  const ImpactBasis& velocity;
  const DisplacementOperators& y;
  const VelocityOperators& v;
  const Weight& weight;
};

struct Range {
  double least = 0, largest = 0;  ///< least <= 0 <= largest
  bool reached = true;            ///< false when bisection was given up: the range holds all the same
  long boxes = 0;                 ///< that were looked at
};

/// Encloses (f + L V - U) / tau over the box of the splines: each product of a y piece and a v piece
/// by the Bernstein coefficients of the residual and the least tau on it, bisected until the bounds
/// are within `slack` of values that are taken.
/// @param expected (least, largest) values that are likely to be taken: they save work, no more
/// @pre inside rounded_upward
Range residual_range(const CheckSetting& setting, const Functional& functional,
                     const Candidate& candidate, std::pair<double, double> expected,
                     double slack);

/// The same outside the box, where V is continued by constants: a bound of |f + L V - U| / tau.
/// @pre inside rounded_upward
double residual_outside(const CheckSetting& setting, const Functional& functional,
                        const Candidate& candidate);

}  // namespace fpkcheck::dual
