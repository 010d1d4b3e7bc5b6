#include "compare/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::compare {

using problem::Equation;
using problem::Impact;
using transform::Solution;
using transform::SolutionRole;
using transform::Variable;

namespace {

constexpr double kUnknownError = std::numeric_limits<double>::infinity();

}  // namespace

const PairDistances* find_pair_distances(std::span<const PairDistances> pairs,
                                         std::string_view first, std::string_view second,
                                         Variable variable) {
  const auto found = std::ranges::find_if(pairs, [&](const PairDistances& pair) {
    const bool same =
        (pair.a == first && pair.b == second) || (pair.a == second && pair.b == first);
    return same && pair.variable == variable;
  });
  return found == pairs.end() ? nullptr : &*found;
}

std::optional<double> l1_distance_between(std::span<const PairDistances> pairs,
                                          std::string_view first, std::string_view second,
                                          Variable variable) {
  const PairDistances* pair = find_pair_distances(pairs, first, second, variable);
  if (pair == nullptr || !std::isfinite(pair->distances.l1)) return std::nullopt;
  return pair->distances.l1;
}

double l1_error_estimate(const Solution& solution, Variable variable) {
  if (solution.error) return l1(*solution.error, variable);
  if (const auto& sampling = best_sampling_error(solution)) {
    return expected_l1_error(*sampling, variable).value_or(kUnknownError);
  }
  return kUnknownError;
}

double l1_error_estimate(const Solution& solution) {
  return l1_error_estimate(solution, Variable::y) + l1_error_estimate(solution, Variable::ydot);
}

bool is_solution_of_full_problem(const Solution& solution) {
  const auto& identity = solution.identity;
  const bool independent =
      identity.role == SolutionRole::equation || identity.role == SolutionRole::simulation;
  return solution.is_ok() && solution.has_density() && independent &&
         identity.equation == Equation::kf && identity.impact && *identity.impact != Impact::delta;
}

const Solution* select_reference(std::span<const Solution> solutions) {
  const Solution* best = nullptr;
  for (const auto& solution : solutions) {
    if (!is_solution_of_full_problem(solution)) continue;
    if (best == nullptr || !(l1_error_estimate(*best) < l1_error_estimate(solution)))
      best = &solution;
  }
  return best;
}

std::string reference_text(std::span<const Solution> solutions) {
  const Solution* chosen = select_reference(solutions);
  if (chosen == nullptr) {
    return "There is no reference: no solution of the full problem has status ok.";
  }
  const double y = l1_error_estimate(*chosen, Variable::y),
               ydot = l1_error_estimate(*chosen, Variable::ydot);
  const std::string known =
      std::isfinite(y + ydot)
          ? fmt::format(
                ", the solution with the smallest error estimate (L1 {:.1g} in p(y), {:.1g} in "
                "p(y'))",
                y, ydot)
          : std::string();
  return fmt::format("Reference: {}{}.", chosen->id(), known);
}

std::vector<ReferenceDistance> closures_by_reference_distance(
    std::span<const Solution> solutions, std::span<const PairDistances> pairs) {
  const Solution* reference_solution = select_reference(solutions);
  std::vector<ReferenceDistance> ranks;
  if (reference_solution == nullptr) return ranks;
  for (const auto& solution : solutions) {
    if (solution.identity.role != SolutionRole::closure || !solution.is_ok()) continue;
    const auto y = l1_distance_between(pairs, solution.id(), reference_solution->id(), Variable::y);
    const auto ydot =
        l1_distance_between(pairs, solution.id(), reference_solution->id(), Variable::ydot);
    if (y && ydot) ranks.push_back({&solution, *y, *ydot});
  }
  std::ranges::stable_sort(ranks, {}, &ReferenceDistance::l1_sum);
  return ranks;
}

bool are_indistinguishable(const ReferenceDistance& first, const ReferenceDistance& second,
                           const Solution& reference) {
  const double error = l1_error_estimate(reference);
  return std::isfinite(error) && std::abs(first.l1_sum() - second.l1_sum()) <= error;
}

}  // namespace fpkcheck::compare
