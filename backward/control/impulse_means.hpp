#pragma once

#include <Eigen/Core>
#include <span>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::backward {

/// Means (K B_j)(v) = E[B_j(v + Y)] of the splines after an impulse, at the velocities v, for every
/// amplitude law. The smooth pieces of the density of Y are divided at the breaks of the splines,
/// and into parts no longer than the standard deviation of Y. The Gauss rule of 8 points integrates
/// each part with an error of 1e-15. Atoms of the law are summed exactly.
/// @return shape (points, functions)
Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseLaw& law, std::span<const double> v);
/// Means (K B_j)(v) for the amplitude law of an impulse train; shape (0, 0) without impulses.
Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseTrain& impulses, std::span<const double> v);

}  // namespace fpkcheck::backward
