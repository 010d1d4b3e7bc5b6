#pragma once

#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace fpkcheck::epc::half_plane {

/// Tries levels in their order: the first result whose density has decayed below what is allowed,
/// else the one whose density has decayed most; none when every attempt is lost.
/// @param attempt level -> optional pair of a result and its density at the place that matters,
///   relative to the peak
template <class Result, class Attempt>
std::optional<Result> first_decayed(const std::vector<double>& levels, double allowed,
                                    const Attempt& attempt) {
  std::optional<Result> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double level : levels) {
    std::optional<std::pair<Result, double>> found = attempt(level);
    if (!found) continue;
    auto& [result, density] = *found;
    if (!best || density < least) {
      best = std::move(result);
      least = density;
    }
    if (least < allowed) break;
  }
  return best;
}

}  // namespace fpkcheck::epc::half_plane
