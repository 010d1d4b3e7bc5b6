#pragma once

#include <span>
#include <vector>

#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

/// Splines B_b of the velocity v on [-u_max, r u_max], constant outside this interval. The incoming
/// side, v = -u, and the outgoing side, v = r u, have the same splines as functions of the impact
/// speed u. The two sides are joined continuously at v = 0 (an inner knot of full multiplicity).
///
/// Let V(0, v) = sum_b c_b B_b(v) at a wall y = 0. If c_b equals c_{basis_index_after_impact(b)}
/// for all b, then the impact condition V(0, r u) = V(0, -u) holds exactly for all u, even with
/// rounding of r u.
class ImpactSplineBasis {
 public:
  /// @param speed_basis splines of the impact speed u on [0, u_max]
  /// @param restitution restitution coefficient r
  ImpactSplineBasis(numerics::SplineBasis speed_basis, double restitution)
      : speed_basis_(std::move(speed_basis)), restitution_(restitution) {}

  const numerics::SplineBasis& speed_basis() const { return speed_basis_; }
  double restitution() const { return restitution_; }
  /// Returns the number of splines B_b.
  int size() const { return 2 * speed_basis_.size() - 1; }
  /// Returns the index of the only spline that is nonzero at v = 0.
  int basis_index_at_zero_velocity() const { return speed_basis_.size() - 1; }
  /// Returns the index of the spline on the other side of v = 0 with the same spline of the impact
  /// speed as B_b.
  int basis_index_after_impact(int b) const { return size() - 1 - b; }
  /// Returns the index b of the spline B_b that is the spline `speed_index` of the impact speed on
  /// the incoming side, v = -u, or on the outgoing side, v = r u.
  int incoming_basis_index(int speed_index) const {
    return basis_index_at_zero_velocity() - speed_index;
  }
  int outgoing_basis_index(int speed_index) const {
    return basis_index_at_zero_velocity() + speed_index;
  }
  /// Returns the ends -u_max and r u_max of the interval of the splines.
  double lowest_velocity() const { return -speed_basis_.end(); }
  double highest_velocity() const { return restitution_ * speed_basis_.end(); }

 private:
  numerics::SplineBasis speed_basis_;
  double restitution_;
};

/// Part of the velocity axis of an ImpactSplineBasis.
enum class VelocityAxisPart {
  below,     ///< velocities v < -u_max, where the first function is 1
  incoming,  ///< velocities v = -u before impacts
  outgoing,  ///< velocities v = r u after impacts
  above      ///< velocities v > r u_max, where the last function is 1
};

/// Segment [begin, end] of the velocity axis, within one knot span of an ImpactSplineBasis or
/// beyond all knot spans.
struct VelocityAxisPiece {
  VelocityAxisPart side;
  int knot_span;                  ///< knot span of the impact speed; 0 beyond all knot spans
  numerics::Interval begin, end;  ///< increasing ends of the segment in v
  /// Upper bound of the length by which the segment extends past the knot span, due to rounding of
  /// the ends
  double rounding_overhang;

  numerics::Interval length() const { return end - begin; }
};

/// Basis functions that are nonzero on a piece, as polynomials of t = (v - begin)/(end - begin).
struct BasisFunctionsOnVelocityPiece {
  std::vector<int> indices;  ///< indices b of the basis functions
  /// Enclosed Bernstein coefficients of each basis function
  std::vector<numerics::BernsteinCoefficients> polynomials;
  /// Upper bound of |basis function - polynomial| on the segment, valid for every basis function; 0
  /// without overhang
  double overhang_error;
};

/// Makes the piece of a segment of the velocity axis. The piece belongs to the knot span that
/// contains the midpoint of the segment.
VelocityAxisPiece make_velocity_piece(const ImpactSplineBasis& basis,
                                      const numerics::Interval& begin,
                                      const numerics::Interval& end);

/// Returns the basis functions that are nonzero on a piece.
BasisFunctionsOnVelocityPiece basis_functions_on_piece(const ImpactSplineBasis& basis,
                                                       const VelocityAxisPiece& piece);

/// Returns enclosures on a piece of the derivatives dS_l/dv, l = 1 .. degree, of the partial sums
/// S_l = B_l + B_{l+1} + .. over the functions of the piece, in the order of
/// basis_functions_on_piece(). Each derivative is a multiple of a single B-spline of degree p - 1.
std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const ImpactSplineBasis& basis, const VelocityAxisPiece& piece);

/// Divides the interval [-u_max, r u_max] of the basis into pieces. The pieces end at the ends of
/// all knot spans and at `cuts`, and are not longer than `max_length`.
std::vector<VelocityAxisPiece> divide_velocity_axis(const ImpactSplineBasis& basis,
                                                    std::span<const double> cuts,
                                                    double max_length);

/// Returns the velocities at which the basis is not smooth, the ends of all knot spans, in
/// increasing order.
std::vector<double> basis_break_velocities(const ImpactSplineBasis& basis);

/// Returns enclosures of the derivatives S_l', l = 1 .. p, of partial sums of B-splines on the
/// segment from `from` to `to` of a knot span, where S_l = B_{span+l} + B_{span+l+1} + .. and S_0 =
/// 1. The derivative of a spline with coefficients c is sum_{l=1}^p (c_{span+l} - c_{span+l-1})
/// S_l' with
///
///     S_l' = p N_{span+l} / (t_{span+l+p} - t_{span+l}),   N of degree p - 1 on the same knots t
///
/// (de Boor, A Practical Guide to Splines, ch. X).
std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const numerics::SplineBasis& basis, int knot_span, const numerics::Interval& from,
    const numerics::Interval& to);

}  // namespace fpkcheck::backward
