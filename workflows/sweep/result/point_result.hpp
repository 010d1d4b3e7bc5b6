#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transform/solution.hpp"

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

}  // namespace fpkcheck::sweep
