#pragma once

#include <Eigen/Core>
#include <span>

#include "numerics/splines/quintic_bsplines.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::backward {

/// (K B_j)(v) = E[B_j(v + Y)] at points, for every law. The smooth pieces of its density are
/// divided at the breaks of the splines and into parts no longer than the deviation, and integrated
/// by the Gauss rule of 8 points with an error of 1e-15. Atoms are summed exactly.
/// @return shape (points, functions)
Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseLaw& law, std::span<const double> v);
/// The same for an impulse train; empty (shape (0, 0)) without impulses.
Eigen::MatrixXd impulse_means(const numerics::QuinticBSplines& splines,
                              const problem::ImpulseTrain& impulses, std::span<const double> v);

}  // namespace fpkcheck::backward
