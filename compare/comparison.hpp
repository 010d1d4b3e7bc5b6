#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// The pairwise distances of the solutions of a case, and the error budgets of the closures.
struct SolutionComparison {
  /// Marginal densities over the comparison bins: first p(y) of all solutions, then p(y').
  std::vector<SolutionMarginalDensity> marginals;
  /// Marginal densities over smooth bins; empty unless a solution has smooth estimates.
  std::vector<SolutionMarginalDensity> smooth;
  std::vector<SolutionPairDistances>
      pairs;  ///< distances of all pairs of solutions in p(y) and p(y')
  std::vector<ErrorBudgetRow> budget;
};

/// Computes the marginal densities of all solutions with a density, the distances of all pairs, and
/// the error budgets of the closures. If a smooth reference exists, the budgets and most distances
/// from the smooth reference are computed over smooth bins (SolutionPairDistances).
/// @param solutions by increasing trust. The second solution of each compared pair is more trusted
///   than the first solution.
SolutionComparison compare_solutions(const ComparisonBins& axes,
                                     std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
