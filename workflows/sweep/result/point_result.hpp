#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// The L1 values (distances or errors) of the two marginal densities.
struct MarginalPair {
  double y, ydot;

  bool operator==(const MarginalPair&) const = default;
};

/// The L1 contribution of one part of the error budget (compare/budget.hpp).
struct BudgetShare {
  std::string part;  ///< compare::BudgetPart::name
  MarginalPair l1;

  bool operator==(const BudgetShare&) const = default;
};

/// The values of a solution that a sweep stores.
struct MethodResult {
  transform::Status status = transform::Status::failed;
  std::string reason = {};  ///< empty where the status is ok
  double seconds = 0;
  std::optional<transform::Moments> moments = {};
  std::optional<MarginalPair> l1 = {};     ///< distance to the point's reference
  std::optional<MarginalPair> error = {};  ///< error estimate, or expected sampling error
  std::vector<BudgetShare> budget = {};
};

/// The values of a point that a sweep stores.
struct PointResult {
  std::size_t point = 0;
  double seconds = 0;                   ///< wall-clock time of all methods and comparisons
  std::string reference = {};           ///< id; empty where no solution is of the full problem
  std::vector<MethodResult> methods{};  ///< in the order of the plan's methods
};

}  // namespace fpkcheck::sweep
