#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/page/heat_map_values.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The error source of one moment of a solution: a map of contributions to the error over the phase
/// plane.
struct ErrorMap {
  std::string moment;  ///< symbol on the page: "E[y²]"
  double error;
  SignedRoots values;  ///< error per area over cells, shape (nv, ny)
};

/// The error sources of all solutions of a case, over the cells in which the density is visible.
struct ErrorMaps {
  struct OfSolution {
    std::string solution;  ///< id
    std::vector<ErrorMap> moments;
  };
  std::vector<double> y_edges;        ///< ny + 1
  std::vector<double> v_edges;        ///< nv + 1
  std::vector<OfSolution> solutions;  ///< closures (closest first), then the others
};

/// The error maps of a case.
/// @return nothing if the case has no error sources, or if their cells are not the cells of the
///         joint densities
std::optional<ErrorMaps> error_maps(const results::CaseResult& one);

/// The HTML elements of the heat maps of error sources, with a control; page.js draws the maps.
std::string error_maps_html(const ErrorMaps& maps, const std::string& prefix);

/// The maps of error sources in JSON, the input of page.js.
std::string error_maps_json(const ErrorMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
