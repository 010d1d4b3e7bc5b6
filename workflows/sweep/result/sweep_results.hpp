#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/plan/plan.hpp"
#include "workflows/sweep/result/point_result.hpp"

namespace fpkcheck::sweep {

/// What a sweep found: its plan, and what became of its points.
struct SweepResults {
  Plan plan;
  std::vector<PointResult> points;  ///< by their number, each once; all of them when it is whole

  bool is_whole() const { return points.size() == plan.points.size(); }
  /// Names of all parts of error budgets, in the order in which they come first.
  std::vector<std::string> budget_parts() const;
};

/// The points in order.
SweepResults sweep_results(Plan plan, std::vector<PointResult> points);

/// sweep.csv: a row for each point and method.
std::string csv(const SweepResults& results);

/// sweep.nc: the same with the varied keys as dimensions (of the design product; of others the
/// dimension is `point`). Points that are not there are NaN, their status is -1.
std::string netcdf(const SweepResults& results, const std::string& command);

/// For --json: the plan, and each point with the values of the varied keys.
std::string json(const SweepResults& results, const std::string& command);

}  // namespace fpkcheck::sweep
