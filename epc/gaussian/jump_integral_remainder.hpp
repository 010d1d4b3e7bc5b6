#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/excitation.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {

/// Returns a Gauss quadrature rule for the mean E[g(Y)] of a smooth function g of the impulse Y.
/// The quadrature rule for means over impulses is Gauss-Hermite for the Gaussian law and
/// Gauss-Legendre for the uniform law. For the exponential law, and on either side of the mean of
/// the Laplace law, the quadrature rule is Gauss-Laguerre. For the two-point law of impulses the
/// quadrature points are the two atoms. For other laws of impulses the rule is
/// piecewise_impulse_quadrature_rule().
/// @param points number of points of the Gauss rule (for the Laplace law, on each side of the mean)
numerics::QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points);

/// Returns a quadrature rule for means E[g(Y)] over impulses Y of any law: the atoms of the law,
/// and Gauss-Legendre panels for the density of the law between its break points.
numerics::QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law);

/// Remainder of the jump integral beyond the terms of equation (22) of the paper, projected on the
/// basis under the Gaussian weights,
///
///     lambda ( E[exp( Q(x1, x2 - sgn(x1) Y) - Q(x1, x2) )] - 1 )
///
/// minus the Kramers-Moyal series of the jump integral up to the fourth derivative. The projection
/// of the remainder of the jump integral over the whole plane diverges. If the exponent Q falls at
/// infinity, exp(-Q) grows faster than the Gaussian weights decay. Where the exponent Q_n rises at
/// infinity, the expectation over impulses in the jump integral is infinite. The remainder of the
/// jump integral is therefore integrated only on a disc with a radius of kRadius standard
/// deviations of the Gaussian weights. Impulses that lead to states beyond the radius kRadius +
/// kJumpMargin around the origin are omitted. The projected remainder of the jump integral is
/// insensitive to the radii kRadius and kJumpMargin (table in docs/closure.md).
class JumpIntegralRemainder {
 public:
  static constexpr double kRadius = 5.5;  ///< disc radius in standard deviations of the weights
  /// Width of the margin around the disc for states after an impulse, in standard deviations
  static constexpr double kJumpMargin = 2;

  JumpIntegralRemainder(const GaussianWeightedBasis& basis, const problem::ImpulseTrain& impulses,
                        double radius = kRadius);

  /// Returns the remainder of the jump integral, projected on each basis function.
  /// @param scaled_coefficients coefficients of the polynomial Q_n in the basis
  Eigen::VectorXd projected_remainder(const Eigen::VectorXd& scaled_coefficients) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& scaled_coefficients) const;

 private:
  int sign_of_node_x1(Eigen::Index i) const { return nodes_.x1(i) > 0 ? 1 : -1; }
  /// Returns the weight of each impulse times the ratio exp(Q after the impulse - Q before), for
  /// each quadrature point.
  Eigen::VectorXd weighted_jump_density_ratios(const Eigen::VectorXd& scaled_coefficients) const;

  double rate_;
  RateTimesMoments series_;  ///< coefficients of the subtracted Kramers-Moyal series
  GaussianProjectionNodes nodes_;
  Eigen::Index jumps_;  ///< number of points of the quadrature rule of the impulse law
  /// Changes of the basis functions by an impulse: row i * jumps_ + j has the values after impulse
  /// j from quadrature point i minus the values at point i.
  Eigen::MatrixXd increments_;
  Eigen::VectorXd jump_weights_;  ///< quadrature weights, 0 for a jump to a point beyond the margin
};

}  // namespace fpkcheck::epc::gaussian
