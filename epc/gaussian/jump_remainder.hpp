#pragma once

#include <vector>

#include <Eigen/Core>

#include "epc/gaussian/projection_nodes.hpp"

namespace fpkcheck::problem {
class ImpulseTrain;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::gaussian {

/// What the jump integral has beyond the terms of paper (22),
///
///     lambda ( E[exp( Q(x1, x2 - sgn(x1) Y) - Q(x1, x2) )] - 1 ) - [its Kramers-Moyal series up to
///     the fourth derivative],
///
/// projected on the basis under the Gaussian weights. That projection over the whole plane does not
/// exist: far out, exp(-Q) of a Q_n with a negative leading form outgrows the weights, and where
/// Q_n rises the expectation itself is infinite. As the series has taken what is large, the rest is
/// taken on the disc of kRadius deviations of the weights, with jumps from within kReach; there the
/// result hardly depends on either (docs/closure.md has the table).
class JumpRemainder {
 public:
  static constexpr double kRadius = 5.5;
  static constexpr double kReach = 2;  ///< beyond the disc, in deviations

  JumpRemainder(const Basis& basis, const problem::ImpulseTrain& impulses, double radius = kRadius);

  /// In the scaled unknowns, shape (basis.size()).
  Eigen::VectorXd projection(const Eigen::VectorXd& a) const;
  /// Its derivative by unknown k in column k.
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& a) const;

 private:
  int side(Eigen::Index i) const { return nodes_.x1(i) > 0 ? 1 : -1; }
  /// Weights times exp(Q after the jump - Q before) for each node and jump.
  Eigen::VectorXd gains(const Eigen::VectorXd& a) const;

  double rate_;
  RateMoments series_;  ///< of the series that is taken off
  ProjectionNodes nodes_;
  Eigen::Index jumps_;  ///< of the law's rule
  /// For each node in turn and each jump: the basis functions there less those at the node.
  Eigen::MatrixXd increments_;
  Eigen::VectorXd jump_weights_;  ///< zero for a jump from outside the reach
};

}  // namespace fpkcheck::epc::gaussian
