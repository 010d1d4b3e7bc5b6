#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Points of the map within this distance of a problem count as nearby.
inline constexpr double kNearbyDistance = 1;
/// Least number of points for each method: with fewer nearby, the closest points at any distance.
inline constexpr std::size_t kMinNearbyPoints = 4;

/// Results of a method at the points closest to a problem, among the points where it was tried:
/// those within kNearbyDistance, and at least kMinNearbyPoints.
struct NearbyResults {
  std::string id;
  std::size_t points = 0, ok = 0;
  std::size_t underestimated = 0;  ///< points with MappedResult::underestimated and L1 > accuracy
  std::optional<double> worst_l1 = {};  ///< over the densities: `ok` or `inaccurate`
  double seconds = 0;                   ///< median
  /// The method was `ok` at all these points, with L1 plus the reference's error estimate below the
  /// accuracy; there are at least kMinNearbyPoints points, the closest within kNearbyDistance.
  bool promised = false;
};

/// Recommendation of methods for a problem by a validity map. No guarantee: the map has no data
/// between its points.
struct Advice {
  MapCoordinates coordinates;
  double accuracy;
  double nearest_distance;        ///< distance of the closest point; infinite where no
                                  ///< point has the same impulse law and relative mean
  std::size_t nearby_points = 0;  ///< number of points within kNearbyDistance
  /// Methods with `promised` first, by increasing time. Exception: the first method is the most
  /// accurate of those that take at most 1.5 times as long as the fastest.
  std::vector<NearbyResults> methods{};

  bool is_outside_map() const { return nearest_distance > kNearbyDistance; }
  /// The methods with `promised`, the recommended method first.
  std::vector<NearbyResults> promised() const;
};

/// Recommends methods for a problem.
/// @param accuracy largest acceptable L1 error of p(y) and p(y')
Advice advice(const problem::Problem& problem, double accuracy, const ValidityMap& map);

/// The same for given coordinates.
Advice advice(const MapCoordinates& coordinates, double accuracy, const ValidityMap& map);

}  // namespace fpkcheck::sweep
