#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/page/signed_roots.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// How far a solution's joint density is from the reference's.
struct JointDifference {
  std::string solution;  ///< id
  double l1;             ///< over all common cells, and of atoms of rest
  SignedRoots values;    ///< the differences cell by cell, as reference_density
};

/// Joint densities of one case, on the part of the common cells where the reference can be seen.
struct JointMaps {
  std::string reference;                     ///< id
  std::vector<double> y_edges;               ///< ny + 1
  std::vector<double> v_edges;               ///< nv + 1
  std::vector<double> reference_density;     ///< rows of constant y', shape (nv, ny), as drawn
  std::array<double, 2> y_bulk, v_bulk;      ///< where the reference exceeds 1/500 of its peak
  std::vector<JointDifference> differences;  ///< closures, the closest first, then the others
};

/// @return nothing when there is no reference, or nothing that is ok beside it
std::optional<JointMaps> joint_maps(const results::Case& one);

/// The heat maps with their controls, to be filled by page.js.
std::string joint_maps_html(const JointMaps& maps, const std::string& prefix);

/// As page.js reads them, in JSON.
std::string joint_maps_json(const JointMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
