#pragma once

#include <span>
#include <vector>

#include "numerics/interval/interval.hpp"
#include "numerics/splines/spline_basis.hpp"

namespace fpkcheck::backward {

/// Splines B_b of the velocity v on [-u_max, r u_max], constant outside this interval, with the
/// largest impact speed u_max and the restitution coefficient r. The splines of the velocity v = -u
/// before an impact and v = r u after the impact are the same functions of the impact speed u. The
/// splines of negative and of positive velocities are joined continuously at v = 0 (an inner knot
/// of full multiplicity).
///
/// Let V(0, v) = sum_b c_b B_b(v) at a wall y = 0. If the coefficients satisfy c_b =
/// c_{basis_index_after_impact(b)} for all b, then V = sum_b c_b B_b satisfies the impact condition
/// V(0, r u) = V(0, -u) exactly for all u, even with rounding of r u.
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
  /// Returns the index of the only spline of v that is nonzero at v = 0.
  int basis_index_at_zero_velocity() const { return speed_basis_.size() - 1; }
  /// Returns the index of the spline at velocities of the other sign that is the same function of
  /// the impact speed as the spline B_b.
  int basis_index_after_impact(int b) const { return size() - 1 - b; }
  /// Returns the index b of the spline B_b that equals the spline `speed_index` of the impact speed
  /// u before the impact, v = -u, or after the impact, v = r u.
  int incoming_basis_index(int speed_index) const {
    return basis_index_at_zero_velocity() - speed_index;
  }
  int outgoing_basis_index(int speed_index) const {
    return basis_index_at_zero_velocity() + speed_index;
  }
  /// Returns the ends -u_max and r u_max of the interval of the splines of the velocity.
  double lowest_velocity() const { return -speed_basis_.end(); }
  double highest_velocity() const { return restitution_ * speed_basis_.end(); }

 private:
  numerics::SplineBasis speed_basis_;
  double restitution_;
};

/// Part of the velocity axis on which all splines of ImpactSplineBasis are polynomials.
enum class VelocityAxisPart {
  below,     ///< velocities v < -u_max, where the first function is 1
  incoming,  ///< velocities v = -u before impacts
  outgoing,  ///< velocities v = r u after impacts
  above      ///< velocities v > r u_max, where the last function is 1
};

/// Segment [begin, end] of the velocity axis, within one knot span of the splines ImpactSplineBasis
/// or beyond all knot spans.
struct VelocityAxisPiece {
  VelocityAxisPart side;
  int knot_span;                  ///< knot span of the impact speed; 0 beyond all knot spans
  numerics::Interval begin, end;  ///< increasing ends of the segment in v
  /// Upper bound of the length by which the segment of the velocity axis extends past the knot
  /// span, due to rounding of its ends
  double rounding_overhang;

  numerics::Interval length() const { return end - begin; }
};

/// Splines that are nonzero on a piece of the velocity axis, as polynomials of the position t = (v
/// - begin)/(end - begin).
struct BasisFunctionsOnVelocityPiece {
  std::vector<int> indices;  ///< indices b of the basis functions
  /// Bernstein coefficients of each basis function, enclosed in intervals
  std::vector<numerics::BernsteinCoefficients> polynomials;
  /// Upper bound of the difference between spline and polynomial on a piece of the velocity axis,
  /// valid for every spline; 0 without overhang
  double overhang_error;
};

/// Makes the piece of the velocity axis with the given ends. The piece of the velocity axis belongs
/// to the knot span that contains the midpoint of the piece.
VelocityAxisPiece make_velocity_piece(const ImpactSplineBasis& basis,
                                      const numerics::Interval& begin,
                                      const numerics::Interval& end);

/// Returns the basis functions that are nonzero on a piece of the velocity axis.
BasisFunctionsOnVelocityPiece basis_functions_on_piece(const ImpactSplineBasis& basis,
                                                       const VelocityAxisPiece& piece);

/// Returns enclosures on a piece of the derivatives dS_l/dv, l = 1 .. degree, of the partial sums
/// S_l = B_l + B_{l+1} + .. over the splines of the piece, in the order of
/// basis_functions_on_piece(). The derivative of each partial sum of B-splines of degree p is a
/// multiple of a single B-spline of degree p - 1.
std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const ImpactSplineBasis& basis, const VelocityAxisPiece& piece);

/// Divides the interval [-u_max, r u_max] of the velocity splines into pieces. The pieces of the
/// velocity axis end at the ends of all knot spans and at `cuts`, and are not longer than
/// `max_length`.
std::vector<VelocityAxisPiece> divide_velocity_axis(const ImpactSplineBasis& basis,
                                                    std::span<const double> cuts,
                                                    double max_length);

/// Returns the velocities at which the splines are not smooth, the ends of knot spans.
std::vector<double> basis_break_velocities(const ImpactSplineBasis& basis);

/// Returns enclosures of the derivatives S_l', l = 1 .. p, of partial sums of B-splines on the
/// segment from `from` to `to` of a knot span, where S_l = B_{span+l} + B_{span+l+1} + .. and S_0 =
/// 1. The derivative of a spline of degree p with coefficients c is sum_{l=1}^p (c_{span+l} -
/// c_{span+l-1}) S_l' with
///
///     S_l' = p N_{span+l} / (t_{span+l+p} - t_{span+l}),   N of degree p - 1 on the same knots t
///
/// (de Boor, A Practical Guide to Splines, ch. X).
std::vector<numerics::BernsteinCoefficients> enclose_slopes_of_basis_partial_sums(
    const numerics::SplineBasis& basis, int knot_span, const numerics::Interval& from,
    const numerics::Interval& to);

}  // namespace fpkcheck::backward
