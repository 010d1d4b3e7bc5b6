#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/case_report.hpp"
#include "transform/density.hpp"

namespace fpkcheck::compare {

/// The joint density of (y, y') of one solution of one case, as averages over common cells.
struct JointDensity {
  std::string case_name;
  std::string solution;  ///< id
  transform::GridDensity density;
};

/// The joint densities of all solutions that have one, whatever their status, in the order of the
/// cases and their solutions. The cells of a case are a tenth of a deviation wide in both
/// directions: those of its comparison axes, two by two along y, so that the histogram of a
/// simulation is summed and not interpolated. Averages are of single precision, as joint.nc holds
/// them.
std::vector<JointDensity> joint_densities(std::span<const CaseReport> cases);

}  // namespace fpkcheck::compare
