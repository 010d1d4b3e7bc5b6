#pragma once

#include <span>
#include <vector>

#include "backward/generator/impact_basis.hpp"
#include "numerics/interval/bernstein.hpp"

namespace fpkcheck::backward {

/// Which polynomials a velocity sees.
enum class Side {
  below,     ///< v < -u_max: the first function is 1
  incoming,  ///< v = -u
  outgoing,  ///< v = r u
  above      ///< v > r u_max: the last function is 1
};

/// A segment of the velocity axis within one span of an ImpactBasis, or beyond all of them.
struct VelocityPiece {
  Side side;
  int span;                     ///< of the speeds; 0 beyond them
  numerics::Interval from, to;  ///< the ends of the segment in v, increasing
  /// How far the segment may reach out of its span, by the rounding of its ends.
  double overhang;

  /// Length of the segment.
  numerics::Interval length() const { return to - from; }
};

/// The functions of a basis on a segment, as polynomials of t = (v - from)/(to - from).
struct PieceFunctions {
  std::vector<int> index;                              ///< functions that do not vanish there
  std::vector<numerics::BernsteinCoefficients> value;  ///< Bernstein coefficients of each
  /// |function - polynomial| on the segment is at most this, for every function: 0 without
  /// overhang.
  double overhang_error;
};

/// The span that holds a segment, decided by its middle.
VelocityPiece located(const ImpactBasis& basis, const numerics::Interval& from,
                      const numerics::Interval& to);
PieceFunctions functions_on(const ImpactBasis& basis, const VelocityPiece& piece);

/// d/dv of S_l = B_l + B_{l+1} + .., l = 1 .. degree, the functions of a piece in the order of
/// functions_on: p B_{p-1} / (a knot distance), one B-spline of the degree below each.
std::vector<numerics::BernsteinCoefficients> difference_slopes(const ImpactBasis& basis,
                                                               const VelocityPiece& piece);

/// Cuts the range of the basis at the ends of all spans and at `cuts`, and into parts no longer
/// than `longest`.
std::vector<VelocityPiece> pieces_of(const ImpactBasis& basis, std::span<const double> cuts,
                                     double longest);
/// The points of the velocity axis where the basis is not smooth: ends of spans, increasing.
std::vector<double> velocity_breaks(const ImpactBasis& basis);

}  // namespace fpkcheck::backward
