#pragma once

#include <span>
#include <vector>

#include "compare/axes.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// The joint densities of all solutions that have one, whatever their status, in their order. The
/// cells are a tenth of a deviation wide in both directions: those of the comparison axes, two by
/// two along y, so that the histogram of a simulation is summed and not interpolated. Averages are
/// of single precision, as joint.nc holds them.
std::vector<JointDensity> joint_densities(const compare::ComparisonAxes& axes,
                                          std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::results
