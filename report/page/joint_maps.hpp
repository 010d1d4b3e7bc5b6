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
  SignedRoots values;    ///< the differences over cells, ordered as reference_density
};

/// The joint densities of one case, on those common cells in which the density of the reference is
/// visible.
struct JointMaps {
  std::string reference;                     ///< id
  std::vector<double> y_edges;               ///< ny + 1
  std::vector<double> v_edges;               ///< nv + 1
  std::vector<double> reference_density;     ///< rows of constant y', shape (nv, ny)
  std::array<double, 2> y_bulk, v_bulk;      ///< where the reference exceeds peak/500
  std::vector<JointDifference> differences;  ///< closures (closest first), then the others
};

/// The maps of the joint densities of a case.
/// @return nothing if the case has no reference, or no other solution with status ok
std::optional<JointMaps> joint_maps(const results::CaseResult& one);

/// The HTML elements of the heat maps of joint densities, with controls; page.js draws the maps.
std::string joint_maps_html(const JointMaps& maps, const std::string& prefix);

/// The maps of joint densities in JSON, the input of page.js.
std::string joint_maps_json(const JointMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
