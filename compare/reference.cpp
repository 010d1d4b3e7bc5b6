#include "compare/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace fpkcheck::compare {

using problem::Equation;
using problem::Impact;
using transform::Role;
using transform::Solution;
using transform::Variable;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

}  // namespace

const PairDistances* find_pair(std::span<const PairDistances> pairs, std::string_view one,
                               std::string_view other, Variable variable) {
  const auto found = std::ranges::find_if(pairs, [&](const PairDistances& pair) {
    const bool same = (pair.a == one && pair.b == other) || (pair.a == other && pair.b == one);
    return same && pair.variable == variable;
  });
  return found == pairs.end() ? nullptr : &*found;
}

std::optional<double> l1_between(std::span<const PairDistances> pairs, std::string_view one,
                                 std::string_view other, Variable variable) {
  const PairDistances* pair = find_pair(pairs, one, other, variable);
  if (pair == nullptr || !std::isfinite(pair->distances.l1)) return std::nullopt;
  return pair->distances.l1;
}

double own_error(const Solution& solution, Variable variable) {
  if (solution.error) return l1(*solution.error, variable);
  if (const auto& sampling = best_sampling(solution)) {
    return expected(*sampling, variable).value_or(kUnknown);
  }
  return kUnknown;
}

double own_error(const Solution& solution) {
  return own_error(solution, Variable::y) + own_error(solution, Variable::ydot);
}

bool solves_the_problem(const Solution& solution) {
  const auto& identity = solution.identity;
  const bool independent = identity.role == Role::equation || identity.role == Role::simulation;
  return solution.is_ok() && solution.has_density() && independent &&
         identity.equation == Equation::kf && identity.impact && *identity.impact != Impact::delta;
}

const Solution* reference(std::span<const Solution> solutions) {
  const Solution* best = nullptr;
  for (const auto& solution : solutions) {
    if (!solves_the_problem(solution)) continue;
    if (best == nullptr || !(own_error(*best) < own_error(solution))) best = &solution;
  }
  return best;
}

std::string reference_text(std::span<const Solution> solutions) {
  const Solution* chosen = reference(solutions);
  if (chosen == nullptr) {
    return "There is no reference: no solution of the full problem has status ok.";
  }
  const double y = own_error(*chosen, Variable::y), ydot = own_error(*chosen, Variable::ydot);
  const std::string known =
      std::isfinite(y + ydot)
          ? fmt::format(
                ", the solution with the smallest error estimate (L1 {:.1g} in p(y), {:.1g} in "
                "p(y'))",
                y, ydot)
          : std::string();
  return fmt::format("Reference: {}{}.", chosen->id(), known);
}

std::vector<Rank> closures_by_distance(std::span<const Solution> solutions,
                                       std::span<const PairDistances> pairs) {
  const Solution* measure = reference(solutions);
  std::vector<Rank> ranks;
  if (measure == nullptr) return ranks;
  for (const auto& solution : solutions) {
    if (solution.identity.role != Role::closure || !solution.is_ok()) continue;
    const auto y = l1_between(pairs, solution.id(), measure->id(), Variable::y);
    const auto ydot = l1_between(pairs, solution.id(), measure->id(), Variable::ydot);
    if (y && ydot) ranks.push_back({&solution, *y, *ydot});
  }
  std::ranges::stable_sort(ranks, {}, &Rank::sum);
  return ranks;
}

bool indistinguishable(const Rank& one, const Rank& other, const Solution& reference) {
  const double error = own_error(reference);
  return std::isfinite(error) && std::abs(one.sum() - other.sum()) <= error;
}

}  // namespace fpkcheck::compare
