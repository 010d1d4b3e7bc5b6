#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transform/solution.hpp"
#include "workflows/sweep/plan/plan.hpp"

namespace fpkcheck::sweep {

/// The L1 values (distances or errors) of the two marginal densities.
struct MarginalL1Pair {
  double y, ydot;

  bool operator==(const MarginalL1Pair&) const = default;
};

/// The L1 contribution of one part of the error budget (compare/error_budget.hpp).
struct BudgetContribution {
  std::string part;  ///< compare::ErrorBudgetPart::name
  MarginalL1Pair l1;

  bool operator==(const BudgetContribution&) const = default;
};

/// The values of a solution that a sweep stores.
struct MethodResult {
  transform::Status status = transform::Status::failed;
  std::string reason = {};  ///< empty where the status is ok
  double seconds = 0;
  std::optional<transform::Moments> moments = {};
  std::optional<MarginalL1Pair> l1 = {};     ///< distance to the point's reference
  std::optional<MarginalL1Pair> error = {};  ///< error estimate, or expected sampling error
  std::vector<BudgetContribution> budget = {};
};

/// The values of a point that a sweep stores.
struct PointResult {
  std::size_t point = 0;
  double seconds = 0;                   ///< wall-clock time of all methods and comparisons
  std::string reference = {};           ///< id; empty where no solution is of the full problem
  std::vector<MethodResult> methods{};  ///< in the order of the plan's methods
};

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
