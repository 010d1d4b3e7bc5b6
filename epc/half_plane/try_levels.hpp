#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace fpkcheck::epc::half_plane {

/// Solves at confinement levels in their order. Returns the first result with a decay ratio below
/// the limit, else the result with the smallest decay ratio; empty if every attempt failed.
/// @param attempt level -> optional pair of a result and its decay ratio
template <class Result, class Attempt>
std::optional<Result> try_levels(const std::vector<double>& levels, double decay_ratio_limit,
                                 const Attempt& attempt) {
  std::optional<Result> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double level : levels) {
    std::optional<std::pair<Result, double>> outcome = attempt(level);
    if (!outcome) continue;
    auto& [result, density] = *outcome;
    if (!best || density < least) {
      best = std::move(result);
      least = density;
    }
    if (least < decay_ratio_limit) break;
  }
  return best;
}

}  // namespace fpkcheck::epc::half_plane
