#include "compare/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::compare {

using transform::Solution;
using transform::Variable;

double largest_by_chance(double in_99) {
  // Quantiles of |N|, N standard normal, at 1 - kAgreementSignificance / 2 and at 0.99.
  constexpr double kQuantileOfLevel = 3.4808, kQuantile99 = 2.5758;
  static_assert(kAgreementLevel == 1e-3);
  return kQuantileOfLevel / kQuantile99 * in_99;
}

std::optional<double> most_by_chance(const transform::SamplingError& sampling, Variable variable) {
  constexpr double kScatter = 2;
  if (const auto most = in_99(sampling, variable)) return most;
  if (const auto mean = expected(sampling, variable)) return kScatter * *mean;
  return std::nullopt;
}

std::optional<double> largest_explained(const Solution& one, const Solution& other,
                                        Variable variable, bool smooth) {
  double chance = 0, stated = 0;
  int known = 0;
  for (const Solution* solution : {&one, &other}) {
    const auto& sampling = smooth ? best_sampling(*solution) : solution->sampling;
    const auto most = sampling ? most_by_chance(*sampling, variable) : std::nullopt;
    chance = std::hypot(chance, most.value_or(0));
    if (solution->error) stated += l1(*solution->error, variable);
    if (most || solution->error) ++known;
  }
  if (known < (smooth ? 2 : 1)) return std::nullopt;
  return largest_by_chance(chance) + transform::kErrorBand * stated;
}

bool agree(const Solution& one, const Solution& other, std::span<const PairDistances> pairs) {
  return std::ranges::all_of(transform::kVariables, [&](Variable variable) {
    const PairDistances* pair = find_pair(pairs, one.id(), other.id(), variable);
    if (pair == nullptr || !std::isfinite(pair->distances.l1)) return true;
    const auto most = largest_explained(one, other, variable, pair->l1_standard_error.has_value());
    return !most || pair->distances.l1 <= *most;
  });
}

}  // namespace fpkcheck::compare
