#include "compare/comparison.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "compare/limits.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::Variable;

bool has_marginal(const Solution& solution, Variable variable, const std::vector<double>& bins) {
  return solution.density ||
         std::ranges::any_of(solution.estimated_marginals, [&](const auto& estimate) {
           return estimate.first == variable && estimate.second.edges == bins;
         });
}

}  // namespace

Comparison compare_solutions(const ComparisonAxes& axes, std::span<const Solution> solutions) {
  Comparison result;
  for (const auto variable : transform::kVariables) {
    const auto& bins = edges(axes, variable);
    std::vector<SolutionMarginal> found;
    for (const auto& solution : solutions) {
      if (!has_marginal(solution, variable, bins)) continue;
      found.push_back({solution.id(), variable, transform::marginal(solution, variable, bins)});
    }
    for (std::size_t a = 0; a < found.size(); ++a) {
      for (std::size_t b = a + 1; b < found.size(); ++b) {
        result.pairs.push_back({found[a].solution, found[b].solution, variable,
                                distances(found[a].marginal, found[b].marginal)});
      }
    }
    std::ranges::move(found, std::back_inserter(result.marginals));
  }
  result.budget = error_budget(axes, solutions, result.marginals);
  result.limits = limits(result.budget, solutions);
  return result;
}

}  // namespace fpkcheck::compare
