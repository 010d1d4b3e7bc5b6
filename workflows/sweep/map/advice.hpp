#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Within this distance of a problem points of the map speak for it.
inline constexpr double kNear = 1;
/// At least so many points are asked of each method, the nearest ones, however far.
inline constexpr std::size_t kFewestNear = 4;

/// What a method gave at the points nearest to a problem: those within kNear, and at least
/// kFewestNear, of the points where it was asked.
struct MethodNearby {
  std::string id;
  std::size_t points = 0, ok = 0;
  std::size_t misstated = 0;  ///< MappedAnswer::misstated, and off by more than the accuracy
  std::optional<double> worst_l1 = {};  ///< of densities: `ok` or `inaccurate`
  double seconds = 0;                   ///< median
  /// At all of these points it was `ok`, and its L1 and what the reference may be off by, together,
  /// were below the accuracy; the nearest of them is within kNear, and there are kFewestNear of them.
  bool promised = false;
};

/// What a map says of a problem. No guarantee: between its points nobody looked.
struct Advice {
  Place place;
  double accuracy;
  double nearest;        ///< distance of the nearest point; infinite where no point has such
                         ///< impulses (law and mean)
  std::size_t near = 0;  ///< points within kNear
  /// Those that are promised first, by increasing time; but before all others the one to take, the
  /// most accurate of those that take at most half as long again as the quickest.
  std::vector<MethodNearby> methods{};

  bool outside() const { return nearest > kNear; }
  /// The promised ones, the one to take first.
  std::vector<MethodNearby> promised() const;
};

/// @param accuracy largest L1 of p(y) and p(y') that is asked for
Advice advice(const problem::Problem& problem, double accuracy, const ValidityMap& map);

/// The same of a place.
Advice advice(const Place& place, double accuracy, const ValidityMap& map);

}  // namespace fpkcheck::sweep
