#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/figure/heat_map_values.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The difference between the joint density of a solution and the joint density of the reference.
struct JointDifference {
  std::string solution;  ///< id of the solution
  double l1;             ///< L1 distance from the reference over all common cells, including atoms
  QuantisedSignedRoots values;  ///< cell differences in the order of JointMaps::reference_density
};

/// The joint densities of a case on those common cells in which the reference density is large
/// enough to be shown.
struct JointMaps {
  std::string reference;        ///< id of the reference
  std::vector<double> y_edges;  ///< ny + 1 cell edges in y
  std::vector<double> v_edges;  ///< nv + 1 cell edges in y'
  /// Reference density in rows of constant y', shape (nv, ny).
  std::vector<double> reference_density;
  std::array<double, 2> y_bulk, v_bulk;      ///< ranges in which the reference exceeds peak/500
  std::vector<JointDifference> differences;  ///< closures (closest first), then all other solutions
};

/// @return the joint densities on the common cells; empty if the case has no reference, or no `ok`
/// solution besides the reference
std::optional<JointMaps> make_joint_maps(const results::CaseResult& case_result);

/// Returns the HTML elements in which page.js draws the heat maps of joint densities.
std::string joint_maps_html(const JointMaps& maps, const std::string& prefix);

/// Returns the heat maps of joint densities as JSON, the input of the script page.js.
std::string joint_maps_json(const JointMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
