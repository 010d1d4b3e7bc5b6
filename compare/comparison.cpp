#include "compare/comparison.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "compare/limits.hpp"
#include "compare/rest_atoms.hpp"
#include "compare/smooth.hpp"

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

/// @param sharp marginals over uniform bins
/// @param smooth the same marginals over smooth bins, or empty
/// @param noisy solutions with sampling errors over sharp bins
PairDistances pair_of(const std::vector<SolutionMarginal>& sharp,
                      const std::vector<SolutionMarginal>& smooth, std::size_t a, std::size_t b,
                      const Solution* measure, const std::set<std::string>& noisy) {
  const auto& [from, variable, one] = sharp[a];
  const auto& [to, same_variable, other] = sharp[b];
  const bool is_measured = measure != nullptr && (from == measure->id() || to == measure->id()) &&
                           !noisy.contains(from == measure->id() ? to : from);
  if (!is_measured) return {from, to, variable, distances(one, other)};
  const auto& measured = smooth[to == measure->id() ? a : b].marginal;
  return {from, to, variable, distances(smooth[a].marginal, smooth[b].marginal),
          l1_standard_error(measured, *transform::smooth_estimate(*measure, variable))};
}

// Negative values in the tails of an ok solution of a discretised equation are of the size of its
// error (`min_density` reports them). Probabilities are not negative: such values become 0.
void drop_negative(std::span<const Solution> solutions, std::vector<SolutionMarginal>& marginals) {
  for (auto& [id, variable, marginal] : marginals) {
    const Solution* solution = transform::find_solution(solutions, id);
    if (solution == nullptr || !solution->is_ok()) continue;
    if (solution->identity.role != transform::Role::equation) continue;
    for (double& density : marginal.density) density = std::max(0.0, density);
  }
}

}  // namespace

Comparison compare_solutions(const ComparisonAxes& axes, std::span<const Solution> solutions) {
  Comparison result;
  const Solution* measure = smooth_measure(solutions);
  std::set<std::string> noisy;
  for (const auto& solution : solutions) {
    if (&solution != measure && solution.sampling) noisy.insert(solution.id());
  }
  std::vector<SolutionMarginal> over_even_bins;
  for (const auto variable : transform::kVariables) {
    const auto& bins = edges(axes, variable);
    std::vector<SolutionMarginal> found;
    for (const auto& solution : solutions) {
      if (!has_marginal(solution, variable, bins)) continue;
      found.push_back({solution.id(), variable, transform::marginal(solution, variable, bins)});
    }
    std::vector<SolutionMarginal> even;
    for (const auto& one : found) {
      even.push_back({one.solution, variable, on_even_bins(axes, variable, one.marginal)});
    }
    const auto smooth = measure == nullptr ? std::vector<SolutionMarginal>{}
                                           : in_smooth_bins(found, solutions, *measure);
    for (std::size_t a = 0; a < found.size(); ++a) {
      for (std::size_t b = a + 1; b < found.size(); ++b) {
        auto pair = pair_of(even, smooth, a, b, measure, noisy);
        pair.distances.l1 +=
            atom_distance(transform::find_solution(solutions, pair.a)->atoms,
                          transform::find_solution(solutions, pair.b)->atoms, variable);
        result.pairs.push_back(std::move(pair));
      }
    }
    std::ranges::move(found, std::back_inserter(result.marginals));
    std::ranges::move(even, std::back_inserter(over_even_bins));
    std::ranges::copy(smooth, std::back_inserter(result.smooth));
  }
  result.budget =
      error_budget(axes, solutions, measure == nullptr ? over_even_bins : result.smooth);
  result.limits = limits(result.budget, solutions, result.pairs);
  drop_negative(solutions, result.marginals);
  drop_negative(solutions, result.smooth);
  return result;
}

}  // namespace fpkcheck::compare
