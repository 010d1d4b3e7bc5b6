#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"

namespace fpkcheck::compare {

/// Closures of a case whose largest errors (limiting errors) have the same source.
struct ClosuresWithSameLimitingError {
  /// Name of the limiting error, the largest part of the error budget of each closure, summed over
  /// y and y'. The name of the limiting error is empty if the distances of the closures from the
  /// reference are within the error of the reference.
  std::string part;
  std::vector<std::string> closures;
  /// Smallest and largest fraction of the limiting error in the sum of all parts of the error
  /// budget, over the closures of the group.
  double least_fraction = 1, greatest_fraction = 0;

  bool operator==(const ClosuresWithSameLimitingError&) const = default;
};

struct LimitingErrorsOfClosures {
  /// Groups of closures with the same limiting error; empty without an error budget.
  std::vector<ClosuresWithSameLimitingError> groups = {};
  /// Whether the finite-volume solution and the simulation disagree (tested by solutions_agree()).
  bool has_reference_disagreement = false;

  bool operator==(const LimitingErrorsOfClosures&) const = default;
};

LimitingErrorsOfClosures find_limiting_errors(std::span<const ErrorBudgetRow> budget,
                                              std::span<const transform::Solution> solutions,
                                              std::span<const SolutionPairDistances> pairs);

}  // namespace fpkcheck::compare
