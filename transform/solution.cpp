#include "transform/solution.hpp"

#include <algorithm>
#include <stdexcept>

namespace fpkcheck::transform {

std::string_view name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::not_converged:
      return "not_converged";
    case Status::ill_posed:
      return "ill_posed";
    case Status::inadmissible:
      return "inadmissible";
    case Status::failed:
      return "failed";
  }
  return "";
}

Marginal marginal(const Solution& solution, Variable variable, std::span<const double> edges) {
  for (const auto& [estimated, estimate] : solution.estimated_marginals) {
    if (estimated == variable && std::ranges::equal(estimate.edges, edges)) return estimate;
  }
  if (!solution.density) throw std::logic_error("solution " + solution.id + " has no density");
  return marginal(*solution.density, variable, edges);
}

Marginal limit_marginal(const Solution& solution, Variable variable,
                        std::span<const double> edges) {
  if (!solution.density || !solution.extrapolation) {
    throw std::logic_error("solution " + solution.id + " has no limit");
  }
  const auto& [coarser, factor] = *solution.extrapolation;
  Marginal limit = marginal(*solution.density, variable, edges);
  const Marginal before = marginal(coarser, variable, edges);
  for (std::size_t k = 0; k < limit.size(); ++k) {
    limit.density[k] += factor * (limit.density[k] - before.density[k]);
  }
  return limit;
}

}  // namespace fpkcheck::transform
