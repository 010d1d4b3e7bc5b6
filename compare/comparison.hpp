#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/comparison_bins.hpp"
#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// The pairwise distances between the solutions of a case, and the error budgets of the closures.
struct SolutionComparison {
  /// Marginal densities averaged over the comparison bins: first p(y) of all solutions, then p(y').
  std::vector<SolutionMarginalDensity> marginals;
  /// Marginal densities averaged over smooth bins; empty unless a solution has such estimates.
  std::vector<SolutionMarginalDensity> smooth;
  std::vector<SolutionPairDistances>
      pairs;  ///< distances of all pairs of solutions in p(y) and p(y')
  std::vector<ErrorBudgetRow> budget;
};

/// Computes the marginal densities of all solutions, the distances between all pairs, and the error
/// budgets of the closures. If one solution is the smooth reference (a simulation with control
/// variates), the budgets and most distances from this simulation are computed over smooth bins.
/// @param solutions solutions by increasing trust. The second solution of each compared pair is
///   more trusted than the first solution of the pair.
SolutionComparison compare_solutions(const ComparisonBins& axes,
                                     std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
