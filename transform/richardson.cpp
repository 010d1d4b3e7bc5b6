#include "transform/richardson.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace fpkcheck::transform {
namespace {

double l1_of_both_marginals(const GridLevelDifference& grid_level_difference) {
  return grid_level_difference.y_l1 + grid_level_difference.ydot_l1;
}

double observed_order(double before, double last, double ratio) {
  return std::log(before / last) / std::log(ratio);
}

Marginal richardson_limit(const Marginal& middle, const Marginal& fine, double factor) {
  Marginal limit = fine;
  for (std::size_t k = 0; k < limit.size(); ++k) {
    limit.density[k] += factor * (fine.density[k] - middle.density[k]);
  }
  return limit;
}

}  // namespace

double richardson_error_from_differences(double before, double last, double reduction_ratio,
                                         double factor) {
  return factor * std::max(std::abs(last), std::abs(before) / reduction_ratio);
}

std::vector<double> errors_with_common_order(std::span<const double> before,
                                             std::span<const double> last,
                                             std::span<const double> scales, double ratio,
                                             int scheme_order) {
  assert(before.size() == last.size() && last.size() == scales.size());
  double sum_before = 0, sum_last = 0;
  for (std::size_t k = 0; k < last.size(); ++k) {
    sum_before += before[k] / scales[k];
    sum_last += last[k] / scales[k];
  }
  const double observed = std::log(sum_before / sum_last) / std::log(ratio);
  const double order =
      std::isfinite(observed) ? credible_convergence_order(observed, scheme_order) : scheme_order;
  const double reduction = std::pow(ratio, order);
  std::vector<double> errors;
  for (std::size_t k = 0; k < last.size(); ++k) {
    errors.push_back(kErrorSafetyFactor * richardson_error_from_differences(
                                              before[k], last[k], reduction, 1 / (reduction - 1)));
  }
  return errors;
}

GridLevelSolution make_grid_level(const Solution& solution, std::span<const double> y_edges,
                                  std::span<const double> ydot_edges) {
  GridLevelSolution level{marginal(solution, StateVariable::y, y_edges),
                          marginal(solution, StateVariable::ydot, ydot_edges), solution.moments};
  for (const RestAtom& atom : solution.atoms) level.rest_probabilities.push_back(atom.probability);
  return level;
}

GridLevelDifference grid_level_difference(const GridLevelSolution& coarser,
                                          const GridLevelSolution& finer) {
  GridLevelDifference grid_level_difference{.y_l1 = l1_distance(coarser.y, finer.y),
                                            .ydot_l1 = l1_distance(coarser.ydot, finer.ydot),
                                            .moments = {},
                                            .impact_rate = finer.impact_rate - coarser.impact_rate};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    grid_level_difference.moments.*moment = finer.moments.*moment - coarser.moments.*moment;
  }
  if (coarser.rest_probabilities.size() != finer.rest_probabilities.size()) {
    throw std::invalid_argument("grid levels not comparable: different numbers of rest atoms");
  }
  double total_change = 0;  // all atoms at rest have y' = 0
  for (std::size_t k = 0; k < finer.rest_probabilities.size(); ++k) {
    grid_level_difference.rest_probabilities.push_back(finer.rest_probabilities[k] -
                                                       coarser.rest_probabilities[k]);
    grid_level_difference.y_l1 += std::abs(grid_level_difference.rest_probabilities[k]);
    total_change += grid_level_difference.rest_probabilities[k];
  }
  grid_level_difference.ydot_l1 += std::abs(total_change);
  return grid_level_difference;
}

ObservedConvergenceOrders observed_convergence_orders(const GridLevelDifference& before,
                                                      const GridLevelDifference& last,
                                                      double ratio) {
  const auto of = [&](double Moments::*moment) {
    return observed_order(std::abs(before.moments.*moment), std::abs(last.moments.*moment), ratio);
  };
  return {.l1 = observed_order(l1_of_both_marginals(before), l1_of_both_marginals(last), ratio),
          .y2 = of(&Moments::y2),
          .v2 = of(&Moments::v2)};
}

double credible_convergence_order(double observed, int scheme_order) {
  const double above = std::max(0.0, observed - scheme_order - kMaxOrderExcess);
  return std::clamp(std::min(observed, scheme_order - above), 1.0,
                    std::max(1.0, 1.0 * scheme_order));
}

bool has_richardson_limit(double observed, int scheme_order) {
  return observed >= kMinOrderForLimit && observed <= scheme_order + kMaxOrderExcess;
}

RichardsonEstimate richardson_estimate(const GridLevelDifference& before,
                                       const GridLevelDifference& last, double ratio, int order) {
  const ObservedConvergenceOrders orders = observed_convergence_orders(before, last, ratio);
  const double observed = l1_of_both_marginals(before) / l1_of_both_marginals(last);
  const double reduction_ratio = std::clamp(observed, ratio, std::pow(ratio, order));
  const double credible = 1 / (std::pow(ratio, credible_convergence_order(orders.l1, order)) - 1);
  RichardsonEstimate result{
      .orders = orders,
      .reduction_ratio = reduction_ratio,
      .factor = 1 / (reduction_ratio - 1),
      .error = {.y_l1 = last.y_l1 * credible, .ydot_l1 = last.ydot_l1 * credible}};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    result.error.moments.*moment = richardson_error_from_differences(
        before.moments.*moment, last.moments.*moment, reduction_ratio, credible);
  }
  for (std::size_t k = 0; k < last.rest_probabilities.size(); ++k) {
    result.rest_probabilities.push_back(richardson_error_from_differences(
        before.rest_probabilities[k], last.rest_probabilities[k], reduction_ratio, credible));
  }
  const double impact_rate_ratio =
      std::clamp(std::abs(before.impact_rate / last.impact_rate), ratio, reduction_ratio);
  result.impact_rate =
      richardson_error_from_differences(before.impact_rate, last.impact_rate, reduction_ratio,
                                        std::max(credible, 1 / (impact_rate_ratio - 1)));
  return result;
}

Moments richardson_limit(const Moments& fine, const GridLevelDifference& last, double factor) {
  Moments limit = fine;
  for (const auto& [name, symbol, moment, size] : kMoments) {
    limit.*moment += factor * last.moments.*moment;
  }
  return limit;
}

GridLevelSolution richardson_limit(const GridLevelSolution& middle, const GridLevelSolution& fine,
                                   double factor) {
  return {richardson_limit(middle.y, fine.y, factor),
          richardson_limit(middle.ydot, fine.ydot, factor),
          richardson_limit(fine.moments, grid_level_difference(middle, fine), factor)};
}

}  // namespace fpkcheck::transform
