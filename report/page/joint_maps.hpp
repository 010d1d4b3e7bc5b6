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
  std::string solution;  ///< id
  double l1;             ///< L1 distance over all common cells, including atoms
  SignedRoots values;    ///< differences over cells, in the order of reference_density
};

/// The joint densities of a case, on those common cells in which the density of the reference is
/// visible.
struct JointMaps {
  std::string reference;                     ///< id
  std::vector<double> y_edges;               ///< ny + 1
  std::vector<double> v_edges;               ///< nv + 1
  std::vector<double> reference_density;     ///< rows of constant y', shape (nv, ny)
  std::array<double, 2> y_bulk, v_bulk;      ///< ranges in which the reference exceeds peak/500
  std::vector<JointDifference> differences;  ///< closures (closest first), then the other solutions
};

/// @return nothing if the case has no reference, or no other `ok` solution
std::optional<JointMaps> joint_maps(const results::CaseResult& case_result);

/// Returns the HTML elements in which page.js draws the heat maps of joint densities.
std::string joint_maps_html(const JointMaps& maps, const std::string& prefix);

/// Returns the maps of joint densities in JSON, the input of page.js.
std::string joint_maps_json(const JointMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
