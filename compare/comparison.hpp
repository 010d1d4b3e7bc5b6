#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/axes.hpp"
#include "compare/budget.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// The comparison of the solutions of a case.
struct Comparison {
  std::vector<SolutionMarginal> marginals;  ///< of all solutions with a marginal, by variable
  /// The marginals over smooth bins if a solution has smooth estimates; else empty.
  std::vector<SolutionMarginal> smooth;
  std::vector<PairDistances> pairs;  ///< of all pairs of solutions, in both variables
  std::vector<BudgetRow> budget;     ///< error budgets of the closures
  std::string limits;                ///< a sentence on the limiting error of each closure
};

/// Computes the marginals of all solutions with a density, the distances of all pairs in both
/// variables, and the error budget of the closures. If there is a smooth reference, the distances
/// to it and the budget are over its smooth bins.
/// @param solutions by increasing trust: the second solution of a pair is the more trusted
Comparison compare_solutions(const ComparisonAxes& axes,
                             std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
