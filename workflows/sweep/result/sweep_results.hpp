#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transform/solution.hpp"
#include "workflows/sweep/plan/sweep_plan.hpp"

namespace fpkcheck::sweep {

/// L1 distances or L1 errors of the marginal densities p(y) and p(y').
struct MarginalL1Values {
  double y, ydot;

  bool operator==(const MarginalL1Values&) const = default;
};

/// One part of an error budget (compare/error_budget.hpp) with its L1 distance.
struct ErrorBudgetContribution {
  std::string part;  ///< name of the part (compare::ErrorBudgetPart::error_budget_part_name)
  MarginalL1Values l1;

  bool operator==(const ErrorBudgetContribution&) const = default;
};

/// Derivatives of E[y^2] and E[y'^2] with respect to a varied key, with error estimates.
struct MomentSlopes {
  std::string key;
  double y2, v2;
  double y2_error, v2_error;

  bool operator==(const MomentSlopes&) const = default;
};

struct SweepMethodResult {
  transform::Status status = transform::Status::failed;
  std::string reason = {};  ///< reason for a status other than `ok`; empty for `ok`
  double seconds = 0;
  std::optional<transform::Moments> moments = {};
  std::optional<MarginalL1Values> l1 = {};     ///< L1 distances from the reference of the point
  std::optional<MarginalL1Values> error = {};  ///< L1 error estimates, or expected sampling errors
  std::vector<ErrorBudgetContribution> budget = {};
  /// Derivatives with respect to the varied keys, if the method computes these derivatives
  std::vector<MomentSlopes> slopes = {};

  /// Returns the derivatives with respect to a key; a null pointer without derivatives.
  const MomentSlopes* find_slopes(const std::string& key) const;
};

struct SweepPointResult {
  std::size_t point = 0;
  double seconds = 0;  ///< wall-clock time of all methods and comparisons
  /// Id of the reference solution of the point; empty if no solution of the full problem exists.
  std::string reference = {};
  std::vector<SweepMethodResult> methods{};  ///< results in the order of the plan's methods
};

struct SweepResults {
  SweepPlan plan;
  std::vector<SweepPointResult> points;  ///< solved points by increasing number, without duplicates

  bool is_complete() const { return points.size() == plan.points.size(); }
  /// Returns the names of all parts of error budgets, in the order of their first occurrence.
  std::vector<std::string> error_budget_part_names() const;
};

/// Makes the results of a sweep from the results of its points, sorted by point number.
SweepResults make_sweep_results(SweepPlan plan, std::vector<SweepPointResult> points);

/// Returns the contents of sweep.csv, with a row for each sweep point and method.
std::string sweep_csv_text(const SweepResults& results);

/// Returns the contents of the netCDF file sweep.nc, with the values of sweep.csv. For the design
/// `product` the varied keys are the dimensions of the variables in sweep.nc. For designs other
/// than `product` the only dimension in sweep.nc is `point`. In sweep.nc unsolved points have the
/// value NaN and the status -1.
std::string sweep_netcdf_bytes(const SweepResults& results, const std::string& command);

/// Returns the output of --json: the sweep plan, and the results of each point with the values of
/// its varied keys.
std::string sweep_json_text(const SweepResults& results, const std::string& command);

}  // namespace fpkcheck::sweep
