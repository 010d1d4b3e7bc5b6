#include "transform/solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fpkcheck::transform {

bool has_error_estimate(const Solution& solution) {
  const auto& sampling = smallest_known_sampling_errors(solution);
  return std::ranges::all_of(kVariables, [&](StateVariable variable) {
    const bool estimated = std::ranges::any_of(
        solution.estimated_marginals, [&](const auto& one) { return one.first == variable; });
    // An error estimate is required only for marginal densities that the solution has.
    if (!solution.density && !solution.had_density && !estimated) return true;
    if (solution.error && std::isfinite(l1_error_of_marginal(*solution.error, variable)))
      return true;
    return sampling && std::isfinite(expected_l1_error(*sampling, variable).value_or(HUGE_VAL));
  });
}

void require_error_estimate(Solution& solution) {
  if (!solution.has_status_ok() || has_error_estimate(solution)) return;
  solution.status = Status::inaccurate;
  solution.reason = "no error estimate: the method has none and there is no reference";
}

void require_accuracy(double accuracy, const std::string& reason, Solution& solution) {
  require_error_estimate(solution);
  if (!solution.has_status_ok() || !solution.error) return;
  if (std::max(solution.error->y_l1, solution.error->ydot_l1) <= accuracy) return;
  solution.status = Status::inaccurate;
  solution.reason = fmt::format("{} (requested accuracy: {:g})", reason, accuracy);
}

const Solution* find_solution(std::span<const Solution> solutions, std::string_view id) {
  const auto found = std::ranges::find(solutions, id, &Solution::id);
  return found == solutions.end() ? nullptr : &*found;
}

Marginal marginal(const Solution& solution, StateVariable variable, std::span<const double> edges) {
  for (const auto& [estimated, estimate] : solution.estimated_marginals) {
    if (estimated == variable && std::ranges::equal(estimate.edges, edges)) return estimate;
  }
  if (!solution.density) throw std::logic_error("solution " + solution.id() + ": no density");
  return marginal(*solution.density, variable, edges);
}

Marginal richardson_limit_marginal(const Solution& solution, StateVariable variable,
                                   std::span<const double> edges) {
  if (!solution.density || !solution.extrapolation) {
    throw std::logic_error("solution " + solution.id() + ": no grids to extrapolate from");
  }
  const auto& [coarser, factor] = *solution.extrapolation;
  Marginal limit = marginal(*solution.density, variable, edges);
  const Marginal before = marginal(coarser, variable, edges);
  for (std::size_t k = 0; k < limit.size(); ++k) {
    limit.density[k] += factor * (limit.density[k] - before.density[k]);
  }
  return limit;
}

const std::optional<MarginalSamplingErrors>& smallest_known_sampling_errors(
    const Solution& solution) {
  return solution.smooth_sampling ? solution.smooth_sampling : solution.sampling;
}

const SmoothBinEstimate* find_smooth_bin_estimate(const Solution& solution,
                                                  StateVariable variable) {
  for (const auto& [estimated, estimate] : solution.smooth_estimates) {
    if (estimated == variable) return &estimate;
  }
  return nullptr;
}

std::optional<double> expected_l1_error(const MarginalSamplingErrors& sampling,
                                        StateVariable variable) {
  return variable == StateVariable::y ? sampling.y : sampling.ydot;
}

std::optional<double> l1_error_quantile_99(const MarginalSamplingErrors& sampling,
                                           StateVariable variable) {
  return variable == StateVariable::y ? sampling.y_99 : sampling.ydot_99;
}

double l1_error_of_marginal(const ErrorEstimate& error, StateVariable variable) {
  return variable == StateVariable::y ? error.y_l1 : error.ydot_l1;
}

}  // namespace fpkcheck::transform
