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
  Change change{
      .y_l1 = l1(coarser.y, finer.y), .ydot_l1 = l1(coarser.ydot, finer.ydot), .moments = {}};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    change.moments.*moment = finer.moments.*moment - coarser.moments.*moment;
  }
  if (coarser.at_rest.size() != finer.at_rest.size()) {
    throw std::invalid_argument("levels with different numbers of atoms");
  }
  double together = 0;  // all of them are at y' = 0
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

Richardson richardson(const Change& before, const Change& last, double ratio, int order) {
  const double observed = of_both(before) / of_both(last);
  const double fall = std::clamp(observed, ratio, std::pow(ratio, order));
  const double factor = 1 / (fall - 1);
  Richardson result{.orders = observed_orders(before, last, ratio),
                    .fall = fall,
                    .factor = factor,
                    .error = {.y_l1 = last.y_l1 * factor, .ydot_l1 = last.ydot_l1 * factor}};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    result.error.moments.*moment =
        factor * std::max(std::abs(last.moments.*moment), std::abs(before.moments.*moment) / fall);
  }
  for (std::size_t k = 0; k < last.at_rest.size(); ++k) {
    result.at_rest.push_back(
        factor * std::max(std::abs(last.at_rest[k]), std::abs(before.at_rest[k]) / fall));
  }
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
