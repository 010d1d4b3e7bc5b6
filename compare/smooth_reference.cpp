#include "compare/smooth_reference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

namespace fpkcheck::compare {

using transform::Solution;
using transform::StateVariable;

const Solution* find_smooth_reference(std::span<const Solution> solutions) {
  const auto found = std::ranges::find_if(solutions, [](const Solution& s) {
    return s.has_status_ok() && s.identity.role == transform::SolutionRole::simulation &&
           s.identity.equation == problem::DensityEquation::kf && !s.smooth_estimates.empty();
  });
  return found == solutions.end() ? nullptr : &*found;
}

std::vector<SolutionMarginalDensity> to_smooth_bin_marginals(
    std::span<const SolutionMarginalDensity> sharp, std::span<const Solution> solutions,
    const Solution& smooth_reference) {
  std::vector<SolutionMarginalDensity> smooth;
  for (const auto& [id, variable, marginal] : sharp) {
    const auto* estimate = transform::find_smooth_bin_estimate(smooth_reference, variable);
    if (id == smooth_reference.id()) {
      smooth.push_back({id, variable, estimate->averages});
      continue;
    }
    const Solution* solution = transform::find_solution(solutions, id);
    const auto* cells = solution != nullptr && solution->density
                            ? std::get_if<transform::GridDensity>(&*solution->density)
                            : nullptr;
    smooth.push_back(
        {id, variable,
         transform::average_over_smooth_bins(
             cells == nullptr ? marginal
                              : transform::marginal(
                                    *solution, variable,
                                    variable == StateVariable::y ? cells->y_edges : cells->v_edges),
             estimate->bins)});
  }
  return smooth;
}

double l1_standard_error(const transform::Marginal& a,
                         const transform::SmoothBinEstimate& estimate) {
  const auto& p = estimate.averages;
  const std::size_t n = p.size();
  std::vector<double> signed_weight;
  for (std::size_t b = 0; b < n; ++b) {
    signed_weight.push_back(a.density[b] < p.density[b] ? -p.bin_width(b) : p.bin_width(b));
  }
  double variance = 0;
  for (std::size_t b = 0; b < n; ++b) {
    for (std::size_t d = 0; d < n; ++d) {
      variance += signed_weight[b] * estimate.covariance[b * n + d] * signed_weight[d];
    }
  }
  return std::sqrt(std::max(variance, 0.0));
}

}  // namespace fpkcheck::compare
