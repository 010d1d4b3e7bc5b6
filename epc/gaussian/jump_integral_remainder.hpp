#pragma once

#include <Eigen/Core>
#include <vector>

#include "epc/gaussian/gaussian_weighted_basis.hpp"
#include "numerics/quadrature/gauss_rule.hpp"
#include "problem/excitation.hpp"
#include "problem/impulse_law.hpp"

namespace fpkcheck::epc::gaussian {

/// Returns the Gauss rule for the mean E[g(Y)] of a smooth function g of the impulse Y. The Gauss
/// rule is Gauss-Hermite for the Gaussian law and Gauss-Legendre for the uniform law. For the
/// exponential law, and on either side of the mean of the Laplace law, the Gauss rule is
/// Gauss-Laguerre. For the two-point law the quadrature points are the two atoms. Other laws use
/// piecewise_impulse_quadrature_rule().
/// @param points number of points of the Gauss rule (for the Laplace law, on each side of the mean)
numerics::QuadratureRule impulse_quadrature_rule(const problem::ImpulseLaw& law, int points);

/// Returns a quadrature rule for E[g(Y)] for any law of the impulse Y: the atoms of the law, and
/// Gauss-Legendre panels for the density of the law between its break points.
numerics::QuadratureRule piecewise_impulse_quadrature_rule(const problem::ImpulseLaw& law);

/// Remainder of the jump integral beyond the terms of paper (22), projected on the basis under the
/// Gaussian weights,
///
///     lambda ( E[exp( Q(x1, x2 - sgn(x1) Y) - Q(x1, x2) )] - 1 )
///
/// minus the Kramers-Moyal series of this expression up to the fourth derivative. The projection of
/// the jump integral's remainder over the whole plane diverges. If the leading form of the exponent
/// is negative, exp(-Q) outgrows the Gaussian weights. Where the exponent Q_n rises at infinity,
/// the expectation over impulses is infinite. The small remainder is therefore integrated only on a
/// disc with a radius of kRadius standard deviations of the weights. Impulses that lead to points
/// beyond the radius kRadius + kJumpMargin are omitted. The projected remainder is insensitive to
/// kRadius and kJumpMargin (table in docs/closure.md).
class JumpIntegralRemainder {
 public:
  static constexpr double kRadius = 5.5;  ///< disc radius in standard deviations of the weights
  /// Width of the margin around the disc for points after a jump, in standard deviations
  static constexpr double kJumpMargin = 2;

  JumpIntegralRemainder(const GaussianWeightedBasis& basis, const problem::ImpulseTrain& impulses,
                        double radius = kRadius);

  /// Returns the remainder projected on each basis function.
  /// @param scaled_coefficients coefficients of the polynomial Q_n in the basis
  Eigen::VectorXd projected_remainder(const Eigen::VectorXd& scaled_coefficients) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& scaled_coefficients) const;

 private:
  int sign_of_node_x1(Eigen::Index i) const { return nodes_.x1(i) > 0 ? 1 : -1; }
  /// Returns the jump weight times exp(Q after the jump - Q before the jump), for each node and
  /// jump.
  Eigen::VectorXd weighted_jump_density_ratios(const Eigen::VectorXd& scaled_coefficients) const;

  double rate_;
  RateTimesMoments series_;  ///< coefficients of the subtracted Kramers-Moyal series
  GaussianProjectionNodes nodes_;
  Eigen::Index jumps_;  ///< number of points of the quadrature rule of the impulse law
  /// Increments of the basis functions by a jump: row i * jumps_ + j has the values after jump j
  /// from node i minus the values at node i.
  Eigen::MatrixXd increments_;
  Eigen::VectorXd jump_weights_;  ///< quadrature weights, 0 for a jump to a point beyond the margin
};

}  // namespace fpkcheck::epc::gaussian
