#pragma once

#include <vector>

#include <Eigen/Core>

#include "epc/gaussian/projection_nodes.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// Remainder of the jump integral beyond the terms of paper (22),
///
///     lambda ( E[exp( Q(x1, x2 - sgn(x1) Y) - Q(x1, x2) )] - 1 ) - [its Kramers-Moyal series up to
///     the fourth derivative],
///
/// projected on the basis under the Gaussian weights. The projection over the whole plane diverges:
/// for a negative leading form exp(-Q) outgrows the weights, and where Q_n rises the expectation
/// itself is infinite. The series contains the large part of the integral. The remainder is
/// therefore integrated on the disc of kRadius deviations of the weights, with jumps from the disc
/// of kRadius + kJumpMargin. The result is insensitive to both radii (table in docs/closure.md).
class JumpRemainder {
 public:
  static constexpr double kRadius = 5.5;
  static constexpr double kJumpMargin = 2;  ///< width of the margin around the disc, in deviations

  JumpRemainder(const Basis& basis, const problem::ImpulseTrain& impulses, double radius = kRadius);

  /// Projection of the remainder, shape (basis.size()).
  /// @param a scaled coefficients
  Eigen::VectorXd projection(const Eigen::VectorXd& a) const;
  /// Derivative of the projection by a_k in column k.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& a) const;

 private:
  int side(Eigen::Index i) const { return nodes_.x1(i) > 0 ? 1 : -1; }
  /// Weights times exp(Q after the jump - Q before) for each node and jump.
  Eigen::VectorXd density_ratios(const Eigen::VectorXd& a) const;

  double rate_;
  RateMoments series_;  ///< coefficients of the subtracted series
  ProjectionNodes nodes_;
  Eigen::Index jumps_;  ///< number of points of the law's rule
  /// Row i * jumps_ + j: basis functions after jump j from node i minus those at node i.
  Eigen::MatrixXd increments_;
  Eigen::VectorXd jump_weights_;  ///< zero for a jump from outside the margin
};

}  // namespace fpkcheck::epc::gaussian
