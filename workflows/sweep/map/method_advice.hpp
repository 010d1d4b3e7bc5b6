#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Largest distance validity_map_distance() from a problem at which a point of the validity map is
/// nearby.
inline constexpr double kNearbyDistance = 1;
/// Smallest number of map points for the assessment of a method. If fewer points are nearby, the
/// assessment uses the closest points of the map, even beyond kNearbyDistance.
inline constexpr std::size_t kMinNearbyPoints = 4;

/// Results of a method at the points of the validity map closest to a problem. Points without a
/// result of the method are omitted. All remaining points within kNearbyDistance are used, and at
/// least kMinNearbyPoints points.
struct MethodResultsAtNearbyPoints {
  std::string id;
  std::size_t points = 0, ok = 0;
  /// Number of points with an underestimated error and an L1 distance above the requested accuracy.
  std::size_t underestimated = 0;
  /// Largest L1 distance from the reference over the results with status `ok` or `inaccurate`.
  std::optional<double> worst_l1 = {};
  double seconds = 0;  ///< median of the wall-clock times at the used points
  /// Whether the method is expected to be sufficiently accurate. Sufficient accuracy is expected if
  /// at each used map point the status is `ok`, and the L1 distance plus the error estimate of the
  /// reference is below the requested accuracy. At least kMinNearbyPoints map points must be used,
  /// and the closest map point must be within kNearbyDistance.
  bool promised = false;
};

/// Recommendation of methods for a problem. The recommendation is no guarantee, since the validity
/// map has no data between its points.
struct MethodRecommendation {
  ValidityMapCoordinates coordinates;
  double accuracy;
  /// Distance of the closest map point with the impulse law and relative mean of the problem;
  /// infinite if no such point exists.
  double nearest_distance;
  std::size_t nearby_points = 0;  ///< number of map points within kNearbyDistance
  /// Methods with `promised` come first, by increasing time. An exception is the first method: the
  /// most accurate promised method that takes at most 1.5 times as long as the fastest promised
  /// method.
  std::vector<MethodResultsAtNearbyPoints> methods{};

  bool is_outside_map() const { return nearest_distance > kNearbyDistance; }
  /// Returns the results of all methods that are expected to be sufficiently accurate, the
  /// recommended method first.
  std::vector<MethodResultsAtNearbyPoints> sufficiently_accurate_methods() const;
};

/// @param accuracy largest acceptable L1 error of p(y) and p(y')
MethodRecommendation recommend_methods(const problem::Problem& problem, double accuracy,
                                       const ValidityMap& map);

MethodRecommendation recommend_methods(const ValidityMapCoordinates& coordinates, double accuracy,
                                       const ValidityMap& map);

}  // namespace fpkcheck::sweep
