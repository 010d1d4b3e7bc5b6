#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Largest map_distance() between a problem and a point of the validity map that counts as nearby.
inline constexpr double kNearbyDistance = 1;
/// Smallest number of map points for the assessment of a method. If fewer points are nearby, the
/// assessment uses the closest points at any distance.
inline constexpr std::size_t kMinNearbyPoints = 4;

/// Results of a method at the points of the validity map closest to a problem. Points at which the
/// method was not tried are omitted. The other points within kNearbyDistance are used, and at least
/// kMinNearbyPoints points.
struct NearbyMethodResults {
  std::string id;
  std::size_t points = 0, ok = 0;
  /// Points with an underestimated error and an L1 distance above the accuracy.
  std::size_t underestimated = 0;
  /// Largest L1 distance over the results with status `ok` or `inaccurate`.
  std::optional<double> worst_l1 = {};
  double seconds = 0;  ///< median of the wall-clock times
  /// Whether the method is expected to be sufficiently accurate. At each used point the status is
  /// `ok`, and the L1 distance plus the error estimate of the reference is below the accuracy. At
  /// least kMinNearbyPoints points are used, and the closest point is within kNearbyDistance.
  bool promised = false;
};

/// Recommendation of methods for a problem. The recommendation is no guarantee, since the validity
/// map has no data between its points.
struct MethodRecommendation {
  MapCoordinates coordinates;
  double accuracy;
  /// Distance of the closest point with the same impulse law and relative mean; infinite without
  /// such a point.
  double nearest_distance;
  std::size_t nearby_points = 0;  ///< number of points within kNearbyDistance
  /// The methods with `promised` come first, by increasing time. However, the first method is the
  /// most accurate promised method that takes at most 1.5 times as long as the fastest method.
  std::vector<NearbyMethodResults> methods{};

  bool is_outside_map() const { return nearest_distance > kNearbyDistance; }
  /// Returns the results of the methods with `promised`; the recommended method comes first.
  std::vector<NearbyMethodResults> sufficiently_accurate_methods() const;
};

/// @param accuracy largest acceptable L1 error of p(y) and p(y')
MethodRecommendation recommend_methods(const problem::Problem& problem, double accuracy,
                                       const ValidityMap& map);

MethodRecommendation recommend_methods(const MapCoordinates& coordinates, double accuracy,
                                       const ValidityMap& map);

}  // namespace fpkcheck::sweep
