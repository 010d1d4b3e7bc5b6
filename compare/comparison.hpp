#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/axes.hpp"
#include "compare/budget.hpp"
#include "compare/pairs.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::compare {

/// What comes of comparing the solutions of one case.
struct Comparison {
  std::vector<SolutionMarginal> marginals;  ///< of all that have one, by variable
  /// The same in smooth bins, where one of the solutions knows itself so; else empty.
  std::vector<SolutionMarginal> smooth;
  std::vector<PairDistances> pairs;  ///< all of them, in both variables
  std::vector<BudgetRow> budget;     ///< of the closures
  std::string limits;                ///< one sentence: what limits each closure
};

/// Marginals of all solutions that have a density, the distances of all their pairs in both
/// variables, and the error budget of the closures. Where there is a smooth measure, the distances
/// to it and the budget are those in its smooth bins.
/// @param solutions by increasing trust: of a pair, the later one is the more trusted
Comparison compare_solutions(const ComparisonAxes& axes,
                             std::span<const transform::Solution> solutions);

}  // namespace fpkcheck::compare
