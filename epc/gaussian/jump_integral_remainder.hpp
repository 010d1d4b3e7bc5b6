#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/gaussian/basis.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/excitation.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {

/// Quadrature rule for the mean E[g(Y)] of a smooth function g of the impulse. The rule is the
/// Gauss rule of the law about its mean: Gauss-Hermite for the law gaussian, Gauss-Laguerre on
/// either side of the mean for laplace, Gauss-Laguerre for exponential, Gauss-Legendre for uniform.
/// The rule of two_point consists of the atoms. Any other law has
/// piecewise_impulse_quadrature_rule().
/// @param points number of points, for laplace on each side; unused for two_point and for
///        piecewise_impulse_quadrature_rule()
numerics::QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points);

/// Quadrature rule for E[g(Y)] for any law of the impulse Y: the atoms of the law, and
/// Gauss-Legendre panels for the density of the law. Panels end at points where this density is not
/// smooth.
numerics::QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law);

/// Remainder of the jump integral beyond the terms of paper (22),
///
///     lambda ( E[exp( Q(x1, x2 - sgn(x1) Y) - Q(x1, x2) )] - 1 ) - [its Kramers-Moyal series up to
///     the fourth derivative],
///
/// projected on the basis under the Gaussian weights. The projection over the whole plane diverges:
/// if the leading form is negative, exp(-Q) outgrows the weights; where Q_n rises, the expectation
/// itself is infinite. The series contains the large part of the jump integral. The small remainder
/// is therefore integrated on a disc only, whose radius is kRadius standard deviations of the
/// weights. Jumps that leave the disc of radius kRadius + kJumpMargin are omitted. The result is
/// insensitive to both radii (table in docs/closure.md).
class JumpIntegralRemainder {
 public:
  static constexpr double kRadius = 5.5;    ///< radius of the disc, in deviations
  static constexpr double kJumpMargin = 2;  ///< width of the margin around the disc, in deviations

  JumpIntegralRemainder(const Basis& basis, const problem::ImpulseTrain& impulses,
                        double radius = kRadius);

  /// The projection of the remainder, shape (basis.size()).
  /// @param a scaled coefficients
  Eigen::VectorXd projected_remainder(const Eigen::VectorXd& a) const;
  /// Jacobian of the projection: column k is the derivative with respect to a_k.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& a) const;

 private:
  /// Sign of x1 at node i.
  int sign_of_x1(Eigen::Index i) const { return nodes_.x1(i) > 0 ? 1 : -1; }
  /// Jump weight times exp(Q after the jump - Q before the jump), for each node and jump.
  Eigen::VectorXd weighted_density_ratios(const Eigen::VectorXd& a) const;

  double rate_;
  RateTimesMoments series_;  ///< coefficients of the subtracted series
  ProjectionNodes nodes_;
  Eigen::Index jumps_;  ///< number of points of the quadrature rule of the impulse law
  /// Increments of the basis functions by a jump. Row i * jumps_ + j has the values after jump j
  /// from node i minus the values at node i.
  Eigen::MatrixXd increments_;
  Eigen::VectorXd jump_weights_;  ///< quadrature weights; 0 for a jump to a point beyond the margin
};

}  // namespace fpkcheck::epc::gaussian
