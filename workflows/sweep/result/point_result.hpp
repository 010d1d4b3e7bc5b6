#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "transform/solution.hpp"

namespace fpkcheck::sweep {

/// Of both marginals, in L1.
struct MarginalPair {
  double y, ydot;

  bool operator==(const MarginalPair&) const = default;
};

/// What a part of the error budget adds (compare/budget.hpp).
struct BudgetShare {
  std::string part;  ///< compare::BudgetPart::name
  MarginalPair l1;

  bool operator==(const BudgetShare&) const = default;
};

/// What is kept of a solution.
struct MethodResult {
  transform::Status status = transform::Status::failed;
  std::string reason = {};  ///< empty where the status is ok
  double seconds = 0;
  std::optional<transform::Moments> moments = {};
  std::optional<MarginalPair> l1 = {};     ///< distance to the point's reference
  std::optional<MarginalPair> error = {};  ///< by its own account: stated, or expected of chance
  std::vector<BudgetShare> budget = {};
};

/// What is kept of a point.
struct PointResult {
  std::size_t point = 0;
  double seconds = 0;                   ///< wall-clock time of all that it took
  std::string reference = {};           ///< id; empty where no solution solves the problem itself
  std::vector<MethodResult> methods{};  ///< in the order of the plan's
};

}  // namespace fpkcheck::sweep
