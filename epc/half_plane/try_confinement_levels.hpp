#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace fpkcheck::epc::half_plane {

/// Attempts a solution at each of the confinement levels in turn. Returns the first result with a
/// decay ratio below the limit, else the result with the smallest decay ratio. The return value is
/// empty if every attempt failed.
/// @param attempt function that takes a confinement level and returns an optional pair of a result
///        and the decay ratio of the result
template <class Result, class Attempt>
std::optional<Result> try_confinement_levels(const std::vector<double>& levels,
                                             double decay_ratio_limit, const Attempt& attempt) {
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
