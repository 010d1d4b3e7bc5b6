#pragma once

#include <span>
#include <vector>

#include "compare/axes.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// The joint densities of all solutions that have one, of any status, in the order of the
/// solutions. The cells are a tenth of a standard deviation wide in both directions. They join
/// pairs of cells of the comparison axes along y, so that a simulation's histogram is summed and
/// not interpolated. Averages have single precision, as in joint.nc.
std::vector<JointDensity> joint_densities(const compare::ComparisonAxes& axes,
                                          std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::results
