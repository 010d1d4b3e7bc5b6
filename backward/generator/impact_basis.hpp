#pragma once

#include <span>
#include <vector>

#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

/// Splines of the velocity v on [-u_max, r u_max], constant outside this interval. The incoming
/// side, v = -u, and the outgoing side, v = r u, are functions of the impact speed u with equal
/// splines. The two sides are joined continuously at v = 0 (an inner knot of full multiplicity). If
/// at y = 0 the functions `b` and `mirrored_index(b)` have equal coefficients, the impact condition
/// V(0, r u) = V(0, -u) holds exactly for all u, even with rounding of r u.
class ImpactBasis {
 public:
  ImpactBasis(numerics::SplineBasis speeds, double restitution)
      : speeds_(std::move(speeds)), restitution_(restitution) {}

  const numerics::SplineBasis& speeds() const { return speeds_; }
  double restitution() const { return restitution_; }
  int size() const { return 2 * speeds_.size() - 1; }
  /// Returns the index of the only function that is nonzero at v = 0.
  int centre_index() const { return speeds_.size() - 1; }
  int mirrored_index(int b) const { return size() - 1 - b; }
  /// Returns the index of the spline `speed_index` of the impact speed, on the incoming or the
  /// outgoing side.
  int incoming_index(int speed_index) const { return centre_index() - speed_index; }
  int outgoing_index(int speed_index) const { return centre_index() + speed_index; }
  double begin() const { return -speeds_.end(); }
  double end() const { return restitution_ * speeds_.end(); }

 private:
  numerics::SplineBasis speeds_;
  double restitution_;
};

enum class VelocitySide {
  below,     ///< velocities v < -u_max, where the first function is 1
  incoming,  ///< velocities v = -u before impacts
  outgoing,  ///< velocities v = r u after impacts
  above      ///< velocities v > r u_max, where the last function is 1
};

/// Segment of the velocity axis within one span of an ImpactBasis, or beyond all spans.
struct VelocityPiece {
  VelocitySide side;
  int span;                     ///< knot span of the speeds; 0 beyond all spans
  numerics::Interval from, to;  ///< increasing ends of the segment in v
  /// Upper bound of the length by which the segment extends past the knot span, due to rounding of
  /// the ends
  double overhang;

  numerics::Interval length() const { return to - from; }
};

/// Functions of a basis on a segment, as polynomials of t = (v - from)/(to - from).
struct BasisFunctionsOnPiece {
  /// Indices of the basis functions that are nonzero on the segment
  std::vector<int> index;
  std::vector<numerics::BernsteinCoefficients> value;
  /// Upper bound of |function - polynomial| on the segment, valid for every function; 0 without
  /// overhang
  double overhang_error;
};

/// Returns the velocity piece of a segment, assigned to the span that contains the midpoint of the
/// segment.
VelocityPiece velocity_piece_of_segment(const ImpactBasis& basis, const numerics::Interval& from,
                                        const numerics::Interval& to);
BasisFunctionsOnPiece basis_functions_on_piece(const ImpactBasis& basis,
                                               const VelocityPiece& piece);

/// Returns enclosures on a piece of the derivatives dS_l/dv, l = 1 .. degree, of the partial sums
/// S_l = B_l + B_{l+1} + .. over the functions of the piece, in the order of
/// basis_functions_on_piece(). Each derivative is p B_{p-1} / (a knot distance), a single B-spline
/// of degree p - 1.
std::vector<numerics::BernsteinCoefficients> partial_sum_slopes(const ImpactBasis& basis,
                                                                const VelocityPiece& piece);

/// Returns pieces of the range of the basis, divided at the ends of all spans and at `cuts`, and
/// not longer than `largest_length`.
std::vector<VelocityPiece> velocity_pieces(const ImpactBasis& basis, std::span<const double> cuts,
                                           double largest_length);
/// Returns the increasing ends of all spans on the velocity axis, where the basis is not smooth.
std::vector<double> velocity_breaks(const ImpactBasis& basis);

/// Returns enclosures of the derivatives S_l' of partial sums of B-splines on the segment from
/// `from` to `to` of a knot span, where S_l = B_{span+l} + B_{span+l+1} + .. and S_0 = 1. The
/// derivative of a spline with coefficients c is sum_{l=1}^p (c_{span+l} - c_{span+l-1}) S_l' with
///
///     S_l' = p N_{span+l} / (t_{span+l+p} - t_{span+l}),   N of degree p - 1 on the same knots
///
/// (de Boor, A Practical Guide to Splines, ch. X).
std::vector<numerics::BernsteinCoefficients> partial_sum_slopes(const numerics::SplineBasis& basis,
                                                                int span,
                                                                const numerics::Interval& from,
                                                                const numerics::Interval& to);

}  // namespace fpkcheck::backward
