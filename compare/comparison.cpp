#include "compare/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <string>
#include <utility>

#include "compare/rest_atoms.hpp"
#include "compare/smooth_reference.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Solution;
using transform::StateVariable;

bool has_marginal_over_bins(const Solution& solution, StateVariable variable,
                            const std::vector<double>& bins) {
  return solution.density ||
         std::ranges::any_of(solution.estimated_marginals, [&](const auto& estimate) {
           return estimate.first == variable && estimate.second.edges == bins;
         });
}

/// @param sharp marginal densities over uniform bins
/// @param smooth marginal densities over smooth bins, or an empty list
/// @param a, b indices in `sharp` and `smooth` of the two compared marginal densities
/// @param with_sampling_error ids of the solutions with sampling errors over uniform bins
SolutionPairDistances compare_pair(const std::vector<SolutionMarginalDensity>& sharp,
                                   const std::vector<SolutionMarginalDensity>& smooth,
                                   std::size_t a, std::size_t b, const Solution* smooth_reference,
                                   const std::set<std::string>& with_sampling_error) {
  const auto& [from, variable, one] = sharp[a];
  const auto& [to, same_variable, other] = sharp[b];
  const bool is_over_smooth_bins =
      smooth_reference != nullptr &&
      (from == smooth_reference->id() || to == smooth_reference->id()) &&
      !with_sampling_error.contains(from == smooth_reference->id() ? to : from);
  if (!is_over_smooth_bins) return {from, to, variable, compute_distances(one, other)};
  const auto& compared = smooth[to == smooth_reference->id() ? a : b].marginal;
  return {from, to, variable, compute_distances(smooth[a].marginal, smooth[b].marginal),
          l1_standard_error(compared,
                            *transform::find_smooth_bin_estimate(*smooth_reference, variable))};
}

// Replaces negative densities by 0 in `ok` solutions of discretised density equations. Negative
// densities in `ok` solutions are of the order of the discretisation error; Solution::min_density
// states the most negative density.
void clip_negative_densities(std::span<const Solution> solutions,
                             std::vector<SolutionMarginalDensity>& marginals) {
  for (auto& [id, variable, marginal] : marginals) {
    const Solution* solution = transform::find_solution(solutions, id);
    if (solution == nullptr || !solution->has_status_ok()) continue;
    if (solution->identity.role != transform::SolutionRole::equation) continue;
    for (double& density : marginal.density) density = std::max(0.0, density);
  }
}

}  // namespace

const SolutionPairDistances* find_pair_distances(std::span<const SolutionPairDistances> pairs,
                                                 std::string_view first, std::string_view second,
                                                 StateVariable variable) {
  const auto found = std::ranges::find_if(pairs, [&](const SolutionPairDistances& pair) {
    const bool same =
        (pair.a == first && pair.b == second) || (pair.a == second && pair.b == first);
    return same && pair.variable == variable;
  });
  return found == pairs.end() ? nullptr : &*found;
}

std::optional<double> l1_distance_between(std::span<const SolutionPairDistances> pairs,
                                          std::string_view first, std::string_view second,
                                          StateVariable variable) {
  const SolutionPairDistances* pair = find_pair_distances(pairs, first, second, variable);
  if (pair == nullptr || !std::isfinite(pair->distances.l1)) return std::nullopt;
  return pair->distances.l1;
}

SolutionComparison compare_solutions(const ComparisonBins& axes,
                                     std::span<const Solution> solutions) {
  SolutionComparison result;
  const Solution* smooth_reference = find_smooth_reference(solutions);
  std::set<std::string> with_sampling_error;
  for (const auto& solution : solutions) {
    if (&solution != smooth_reference && solution.sampling)
      with_sampling_error.insert(solution.id());
  }
  std::vector<SolutionMarginalDensity> over_uniform_bins;
  for (const auto variable : transform::kVariables) {
    const auto& bins = comparison_bin_edges(axes, variable);
    std::vector<SolutionMarginalDensity> unmerged;
    for (const auto& solution : solutions) {
      if (!has_marginal_over_bins(solution, variable, bins)) continue;
      unmerged.push_back({solution.id(), variable, transform::marginal(solution, variable, bins)});
    }
    std::vector<SolutionMarginalDensity> merged;
    for (const auto& one : unmerged) {
      merged.push_back({one.solution, variable, merge_divided_bins(axes, variable, one.marginal)});
    }
    const auto smooth = smooth_reference == nullptr
                            ? std::vector<SolutionMarginalDensity>{}
                            : to_smooth_bin_marginals(unmerged, solutions, *smooth_reference);
    for (std::size_t a = 0; a < unmerged.size(); ++a) {
      for (std::size_t b = a + 1; b < unmerged.size(); ++b) {
        auto pair = compare_pair(merged, smooth, a, b, smooth_reference, with_sampling_error);
        pair.distances.l1 +=
            rest_atom_l1_distance(transform::find_solution(solutions, pair.a)->atoms,
                                  transform::find_solution(solutions, pair.b)->atoms, variable);
        result.pairs.push_back(std::move(pair));
      }
    }
    std::ranges::move(unmerged, std::back_inserter(result.marginals));
    std::ranges::move(merged, std::back_inserter(over_uniform_bins));
    std::ranges::copy(smooth, std::back_inserter(result.smooth));
  }
  result.budget = compute_error_budget(
      axes, solutions, smooth_reference == nullptr ? over_uniform_bins : result.smooth);
  clip_negative_densities(solutions, result.marginals);
  clip_negative_densities(solutions, result.smooth);
  return result;
}

}  // namespace fpkcheck::compare
