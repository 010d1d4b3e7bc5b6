#include "transform/richardson.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace fpkcheck::transform {
namespace {

double of_both(const Change& change) { return change.y_l1 + change.ydot_l1; }

double order(double before, double last, double ratio) {
  return std::log(before / last) / std::log(ratio);
}

// Error of the finest value of a quantity, from its last two differences.
double error_of(double before, double last, double fall, double factor) {
  return factor * std::max(std::abs(last), std::abs(before) / fall);
}

Marginal limit(const Marginal& middle, const Marginal& fine, double factor) {
  Marginal limit = fine;
  for (std::size_t k = 0; k < limit.size(); ++k) {
    limit.density[k] += factor * (fine.density[k] - middle.density[k]);
  }
  return limit;
}

}  // namespace

Level level(const Solution& solution, std::span<const double> y_edges,
            std::span<const double> ydot_edges) {
  Level level{marginal(solution, Variable::y, y_edges),
              marginal(solution, Variable::ydot, ydot_edges), solution.moments};
  for (const RestAtom& atom : solution.atoms) level.at_rest.push_back(atom.probability);
  return level;
}

Change change(const Level& coarser, const Level& finer) {
  Change change{.y_l1 = l1(coarser.y, finer.y),
                .ydot_l1 = l1(coarser.ydot, finer.ydot),
                .moments = {},
                .impact_rate = finer.impact_rate - coarser.impact_rate};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    change.moments.*moment = finer.moments.*moment - coarser.moments.*moment;
  }
  if (coarser.at_rest.size() != finer.at_rest.size()) {
    throw std::invalid_argument("grid levels not comparable: different numbers of rest atoms");
  }
  double together = 0;  // all atoms have y' = 0
  for (std::size_t k = 0; k < finer.at_rest.size(); ++k) {
    change.at_rest.push_back(finer.at_rest[k] - coarser.at_rest[k]);
    change.y_l1 += std::abs(change.at_rest[k]);
    together += change.at_rest[k];
  }
  change.ydot_l1 += std::abs(together);
  return change;
}

ObservedOrders observed_orders(const Change& before, const Change& last, double ratio) {
  const auto of = [&](double Moments::*moment) {
    return order(std::abs(before.moments.*moment), std::abs(last.moments.*moment), ratio);
  };
  return {.l1 = order(of_both(before), of_both(last), ratio),
          .y2 = of(&Moments::y2),
          .v2 = of(&Moments::v2)};
}

double credible_order(double observed, int of_scheme) {
  const double above = std::max(0.0, observed - of_scheme - kMostAboveOrder);
  return std::clamp(std::min(observed, of_scheme - above), 1.0, std::max(1.0, 1.0 * of_scheme));
}

bool has_limit(double observed, int order_of_scheme) {
  return observed >= kLeastOrderOfALimit && observed <= order_of_scheme + kMostAboveOrder;
}

Richardson richardson(const Change& before, const Change& last, double ratio, int order) {
  const ObservedOrders orders = observed_orders(before, last, ratio);
  const double observed = of_both(before) / of_both(last);
  const double fall = std::clamp(observed, ratio, std::pow(ratio, order));
  const double credible = 1 / (std::pow(ratio, credible_order(orders.l1, order)) - 1);
  Richardson result{.orders = orders,
                    .fall = fall,
                    .factor = 1 / (fall - 1),
                    .error = {.y_l1 = last.y_l1 * credible, .ydot_l1 = last.ydot_l1 * credible}};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    result.error.moments.*moment =
        error_of(before.moments.*moment, last.moments.*moment, fall, credible);
  }
  for (std::size_t k = 0; k < last.at_rest.size(); ++k) {
    result.at_rest.push_back(error_of(before.at_rest[k], last.at_rest[k], fall, credible));
  }
  const double own_fall = std::clamp(std::abs(before.impact_rate / last.impact_rate), ratio, fall);
  result.impact_rate =
      error_of(before.impact_rate, last.impact_rate, fall, std::max(credible, 1 / (own_fall - 1)));
  return result;
}

Moments limit(const Moments& fine, const Change& last, double factor) {
  Moments limit = fine;
  for (const auto& [name, symbol, moment, size] : kMoments) {
    limit.*moment += factor * last.moments.*moment;
  }
  return limit;
}

Level limit(const Level& middle, const Level& fine, double factor) {
  return {limit(middle.y, fine.y, factor), limit(middle.ydot, fine.ydot, factor),
          limit(fine.moments, change(middle, fine), factor)};
}

}  // namespace fpkcheck::transform
