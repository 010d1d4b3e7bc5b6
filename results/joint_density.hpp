#pragma once

#include <span>
#include <vector>

#include "compare/comparison_axes.hpp"
#include "results/run.hpp"

namespace fpkcheck::results {

/// The joint densities of all solutions with a joint density, of any status, in the order of the
/// solutions. The widths of the cells are a tenth of a standard deviation in both directions. Each
/// cell joins two adjacent cells of the comparison axes along y, so that the histogram of a
/// simulation is summed and not interpolated. The averages are rounded to single precision, as in
/// joint.nc.
std::vector<JointDensity> joint_densities(const compare::ComparisonAxes& axes,
                                          std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::results
