#include "compare/study/richardson.hpp"

#include <algorithm>
#include <cmath>

#include "compare/distances.hpp"

namespace fpkcheck::compare {
namespace {

using transform::Marginal;

// Both marginals together: of one alone the differences may pass through 0 by chance.
double difference(const Marginals& a, const Marginals& b) {
  return distances(a.y, b.y).l1 + distances(a.ydot, b.ydot).l1;
}

double order(double before, double last, double ratio) {
  return std::log(before / last) / std::log(ratio);
}

Marginal extrapolated(const Marginal& middle, const Marginal& fine, double factor) {
  Marginal limit = fine;
  for (std::size_t k = 0; k < limit.size(); ++k) {
    limit.density[k] += factor * (fine.density[k] - middle.density[k]);
  }
  return limit;
}

}  // namespace

ObservedOrders observed_orders(const Marginals& coarse, const Marginals& middle,
                               const Marginals& fine, double ratio) {
  const auto of = [&](double transform::Moments::*moment) {
    return order(std::abs(middle.moments.*moment - coarse.moments.*moment),
                 std::abs(fine.moments.*moment - middle.moments.*moment), ratio);
  };
  return {.l1 = order(difference(coarse, middle), difference(middle, fine), ratio),
          .y2 = of(&transform::Moments::y2),
          .v2 = of(&transform::Moments::v2)};
}

RichardsonLimit richardson_limit(const Marginals& coarse, const Marginals& middle,
                                 const Marginals& fine, double ratio, int order_of_scheme) {
  const double observed = difference(coarse, middle) / difference(middle, fine);
  const double fall = std::clamp(observed, ratio, std::pow(ratio, order_of_scheme));
  const double factor = 1 / (fall - 1);
  RichardsonLimit limit{.value = {extrapolated(middle.y, fine.y, factor),
                                  extrapolated(middle.ydot, fine.ydot, factor), fine.moments},
                        .error = {}};
  for (const auto& [name, moment] : kRichardsonMoments) {
    const double before = middle.moments.*moment - coarse.moments.*moment;
    const double step = factor * (fine.moments.*moment - middle.moments.*moment);
    limit.value.moments.*moment += step;
    limit.error.*moment = std::max(std::abs(step), factor * std::abs(before) / fall);
  }
  return limit;
}

}  // namespace fpkcheck::compare
