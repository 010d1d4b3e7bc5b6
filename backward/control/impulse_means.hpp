#pragma once

#include <Eigen/Core>
#include <span>

#include "numerics/splines/knot_splines.hpp"
#include "problem/impulse_train.hpp"

namespace fpkcheck::backward {

/// (K B_j)(v) = E[B_j(v + Y)] at points, for every law: its density's smooth pieces, cut at the
/// breaks of the splines and into parts no longer than the deviation, by Gauss's rule of 8 points,
/// which leaves 1e-15; its atoms as they are.
/// @return shape (points, functions)
Eigen::MatrixXd impulse_means(const numerics::KnotSplines& splines, const problem::ImpulseLaw& law,
                              std::span<const double> v);
/// The same, and nothing (shape (0, 0)) where there are no impulses.
Eigen::MatrixXd impulse_means(const numerics::KnotSplines& splines,
                              const problem::ImpulseTrain& impulses, std::span<const double> v);

}  // namespace fpkcheck::backward
