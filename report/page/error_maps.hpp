#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "report/page/signed_roots.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Where the error of one moment of a solution comes from.
struct ErrorMap {
  std::string moment;  ///< as the page writes it
  double error;
  SignedRoots values;  ///< by cells, shape (nv, ny)
};

/// The sources of the errors of all solutions of a case, where the density can be seen.
struct ErrorMaps {
  struct OfSolution {
    std::string solution;  ///< id
    std::vector<ErrorMap> moments;
  };
  std::vector<double> y_edges;        ///< ny + 1
  std::vector<double> v_edges;        ///< nv + 1
  std::vector<OfSolution> solutions;  ///< closures, the closest first, then the others
};

/// @return nothing where no solution has any
std::optional<ErrorMaps> error_maps(const results::Case& one);

/// The heat maps with their control, to be filled by page.js.
std::string error_maps_html(const ErrorMaps& maps, const std::string& prefix);

/// As page.js reads them, in JSON.
std::string error_maps_json(const ErrorMaps& maps, const std::string& prefix);

}  // namespace fpkcheck::report
