#pragma once

#include <string>

#include "modified_case.hpp"

namespace fpkcheck::tests {

/// made_up_case() with errors of the second moments and their sources: 0.001 and -0.002 in
/// epc-gaussian-n6, a thousandth of these in fd-kf. All sources are in the two cells at the wall
/// next to y' = 0.
/// @param equation id of fd-kf in the case
inline results::CaseResult case_with_sources(const std::string& equation = "fd-kf") {
  auto case_result = made_up_case();
  const auto axes = compare::comparison_bins(case_result.problem);
  case_result.joints.clear();
  for (const char* id : {"fd-kf", "epc-gaussian-n6", "mcs"}) {
    const auto* solution = case_result.find(id);
    if (!solution->density) continue;
    case_result.joints.push_back(
        {id, transform::average_over_cells(std::get<transform::SmoothDensity>(*solution->density),
                                           axes.y_edges, axes.v_edges)});
  }
  case_result.joints.push_back({"mcs", case_result.joints.front().density});
  for (const auto& [id, size] : {std::pair{"epc-gaussian-n6", 1.0}, std::pair{"fd-kf", 1e-3}}) {
    case_result.moment_error_estimates.push_back({id, {}, {.y2 = 1e-3 * size, .v2 = -2e-3 * size}});
    for (const auto& [moment, error] : {std::pair{"y2", 1e-3}, std::pair{"v2", -2e-3}}) {
      results::MomentErrorSource source{id, moment, case_result.joints.front().density};
      auto& map = source.density;
      map.averages.assign(map.y_cell_count() * map.v_cell_count(), 0);
      const double area =
          map.y_edges[1] * map.v_edges.back() * 2 / static_cast<double>(map.v_cell_count());
      map.averages[map.v_cell_count() / 2] = 2 * error * size / area;
      map.averages[map.v_cell_count() / 2 - 1] = -error * size / area;
      case_result.error_sources.push_back(source);
    }
  }
  const auto rename = [&](std::string& id) {
    if (id == "fd-kf") id = equation;
  };
  for (auto& solution : case_result.solutions) rename(solution.identity.id);
  for (auto& estimate : case_result.moment_error_estimates) rename(estimate.solution);
  for (auto& source : case_result.error_sources) rename(source.solution);
  return case_result;
}

}  // namespace fpkcheck::tests
