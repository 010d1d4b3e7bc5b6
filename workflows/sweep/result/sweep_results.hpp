#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// Results of a sweep: its plan and its solved points.
struct SweepResults {
  Plan plan;
  std::vector<PointResult> points;  ///< by number, each once; all points when the sweep is complete

  bool is_complete() const { return points.size() == plan.points.size(); }
  /// Names of all parts of error budgets, in the order of their first occurrence.
  std::vector<std::string> budget_parts() const;
};

/// Results with the points sorted by number.
SweepResults make_sweep_results(Plan plan, std::vector<PointResult> points);

/// Contents of sweep.csv: a row for each point and method.
std::string csv(const SweepResults& results);

/// Contents of sweep.nc: the values of sweep.csv. The design product has the varied keys as
/// dimensions, other designs have the dimension `point`. Missing points have NaN and the status -1.
std::string netcdf(const SweepResults& results, const std::string& command);

/// JSON for --json: the plan, and each point with the values of its varied keys.
std::string json(const SweepResults& results, const std::string& command);

}  // namespace fpkcheck::sweep
