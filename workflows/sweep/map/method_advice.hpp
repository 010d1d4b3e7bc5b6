#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Largest validity_map_distance() between a problem and a nearby point of the validity map.
inline constexpr double kNearbyDistance = 1;
/// Smallest number of points of the validity map with which a method is assessed. If fewer than
/// kMinNearbyPoints points are nearby, the assessment uses the closest points of the validity map,
/// even beyond kNearbyDistance.
inline constexpr std::size_t kMinNearbyPoints = 4;

/// Results of a method at the points of the validity map closest to a problem. Points of the
/// validity map without a result of the method are omitted. All map points within kNearbyDistance
/// that have a result of the method are used, and at least kMinNearbyPoints points.
struct MethodResultsAtNearbyPoints {
  std::string id;
  std::size_t points = 0, ok = 0;
  /// Number of map points with an underestimated error and an L1 distance above the requested
  /// accuracy.
  std::size_t underestimated = 0;
  /// Largest L1 distance from the reference over the results with the status `ok` or `inaccurate`.
  std::optional<double> worst_l1 = {};
  double seconds = 0;  ///< median of the wall-clock times at the used points
  /// Whether the method is expected to have the requested accuracy for the problem. Sufficient
  /// accuracy of a method is expected if at each used map point the status is `ok`, and the L1
  /// distance plus the error estimate of the reference is below the requested accuracy. A method is
  /// expected to be accurate only if at least kMinNearbyPoints map points are used and the closest
  /// map point is within kNearbyDistance.
  bool promised = false;
};

/// Recommendation of methods for a problem. The recommendation of methods is no guarantee, since
/// the validity map has no data between its points.
struct MethodRecommendation {
  ValidityMapCoordinates coordinates;
  double accuracy;
  /// Distance of the closest map point with the impulse law and relative mean of the problem;
  /// infinite if no such point exists.
  double nearest_distance;
  std::size_t nearby_points = 0;  ///< number of map points within kNearbyDistance
  /// Methods that are expected to be accurate (`promised`) come first, sorted by increasing
  /// wall-clock time. The first method of the list is the most accurate promised method that takes
  /// at most 1.5 times as long as the fastest promised method.
  std::vector<MethodResultsAtNearbyPoints> methods{};

  bool is_outside_map() const { return nearest_distance > kNearbyDistance; }
  /// Returns the results of all methods that are expected to be sufficiently accurate, beginning
  /// with the recommended method.
  std::vector<MethodResultsAtNearbyPoints> sufficiently_accurate_methods() const;
};

/// @param accuracy largest acceptable L1 error of p(y) and p(y')
MethodRecommendation recommend_methods(const problem::Problem& problem, double accuracy,
                                       const ValidityMap& map);

MethodRecommendation recommend_methods(const ValidityMapCoordinates& coordinates, double accuracy,
                                       const ValidityMap& map);

}  // namespace fpkcheck::sweep
