#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// The results of a sweep: the plan and the solved points.
struct SweepResults {
  Plan plan;
  std::vector<PointResult> points;  ///< by number, each once; all points when the sweep is complete

  bool is_complete() const { return points.size() == plan.points.size(); }
  /// The names of all parts of error budgets in the results, in the order of their first
  /// occurrence.
  std::vector<std::string> budget_parts() const;
};

/// Makes the results of a sweep, with the points sorted by number.
SweepResults make_sweep_results(Plan plan, std::vector<PointResult> points);

/// The results of a sweep in CSV, with a row for each point and method: the contents of sweep.csv.
std::string csv(const SweepResults& results);

/// The results of a sweep in netCDF with the values of sweep.csv: the contents of sweep.nc. For the
/// design product the varied keys are the dimensions; for other designs the dimension is `point`.
/// Missing points have NaN and the status -1.
std::string netcdf(const SweepResults& results, const std::string& command);

/// The results of a sweep in JSON for --json: the plan, and each point with the values of the
/// varied keys.
std::string json(const SweepResults& results, const std::string& command);

}  // namespace fpkcheck::sweep
