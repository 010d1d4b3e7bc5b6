#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"

namespace fpkcheck::compare {

/// Closures of a case with the same limiting error.
struct LimitingErrorGroup {
  /// Name of the limiting error, the largest part of the error budget of each closure, summed over
  /// both variables. Empty for closures without a limiting error: their distances from the
  /// reference of the budget are within the error of this reference.
  std::string part;
  std::vector<std::string> closures;  ///< ids
  /// Smallest and largest fraction of this part in the sum of all parts, over the closures.
  double least_fraction = 1, greatest_fraction = 0;

  bool operator==(const LimitingErrorGroup&) const = default;
};

/// The limiting errors of the closures of a case.
struct LimitingErrors {
  std::vector<LimitingErrorGroup> groups = {};  ///< empty without an error budget
  /// Whether the part `sampling` of a budget exceeds the sampling error: the finite-volume solution
  /// and the simulation disagree (compare/agreement.hpp).
  bool has_reference_disagreement = false;

  bool operator==(const LimitingErrors&) const = default;
};

LimitingErrors limiting_errors(std::span<const ErrorBudgetRow> budget,
                               std::span<const transform::Solution> solutions,
                               std::span<const PairDistances> pairs);

}  // namespace fpkcheck::compare
