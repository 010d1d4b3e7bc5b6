#pragma once

#include <span>
#include <vector>

#include "backward/generator/impact_basis.hpp"
#include "numerics/interval/bernstein.hpp"

namespace fpkcheck::backward {

/// Part of the velocity axis.
enum class VelocitySide {
  below,     ///< v < -u_max: the first function is 1
  incoming,  ///< v = -u
  outgoing,  ///< v = r u
  above      ///< v > r u_max: the last function is 1
};

/// A segment of the velocity axis within one span of an ImpactBasis, or beyond all spans.
struct VelocityPiece {
  VelocitySide side;
  int span;                     ///< knot span of the speeds; 0 beyond all spans
  numerics::Interval from, to;  ///< ends of the segment in v, increasing
  /// Upper bound of the length by which the segment extends past its span, since the ends of the
  /// segment are rounded.
  double overhang;

  /// Length of the segment.
  numerics::Interval length() const { return to - from; }
};

/// The functions of a basis on a segment, as polynomials of t = (v - from)/(to - from).
struct BasisFunctionsOnPiece {
  /// functions that do not vanish on the segment
  std::vector<int> index;
  std::vector<numerics::BernsteinCoefficients> value;  ///< Bernstein coefficients of each function
  /// Upper bound of |function - polynomial| on the segment, valid for every function; 0 without
  /// overhang.
  double overhang_error;
};

/// The velocity piece of a segment, assigned to the span that contains the midpoint of the segment.
VelocityPiece velocity_piece_of_segment(const ImpactBasis& basis, const numerics::Interval& from,
                                        const numerics::Interval& to);
BasisFunctionsOnPiece basis_functions_on_piece(const ImpactBasis& basis,
                                               const VelocityPiece& piece);

/// Enclosures of dS_l/dv on a piece for l = 1 .. degree. S_l = B_l + B_{l+1} + .. is a sum over the
/// functions of the piece in the order of basis_functions_on_piece(). Each derivative is p B_{p-1}
/// / (a knot distance), a single B-spline of degree p - 1.
std::vector<numerics::BernsteinCoefficients> partial_sum_slopes(const ImpactBasis& basis,
                                                                const VelocityPiece& piece);

/// Pieces of the range of the basis: divided at the ends of all spans and at `cuts`, and so that no
/// piece is longer than `largest_length`.
std::vector<VelocityPiece> velocity_pieces(const ImpactBasis& basis, std::span<const double> cuts,
                                           double largest_length);
/// The ends of all spans on the velocity axis, where the basis is not smooth; increasing.
std::vector<double> velocity_breaks(const ImpactBasis& basis);

}  // namespace fpkcheck::backward
