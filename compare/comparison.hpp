#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/comparison_axes.hpp"
#include "compare/error_budget.hpp"
#include "compare/pair_distances.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// The results of comparing the solutions of a case with each other.
struct Comparison {
  /// Marginal densities over the comparison bins: all solutions in y, then all solutions in y'.
  std::vector<SolutionMarginal> marginals;
  /// The same marginals over smooth bins, if a solution has smooth estimates; else empty.
  std::vector<SolutionMarginal> smooth;
  std::vector<PairDistances> pairs;    ///< distances of all pairs of solutions, in both variables
  std::vector<ErrorBudgetRow> budget;  ///< error budgets of the closures
};

/// Computes the marginals of all solutions with a density, the distances of all pairs of solutions
/// in both variables, and the error budgets of the closures. If there is a smooth reference, the
/// budgets and most distances from the smooth reference are over smooth bins (PairDistances).
/// @param solutions by increasing trust: the second solution of a pair is the more trusted one
Comparison compare_solutions(const ComparisonAxes& axes,
                             std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
