#pragma once

#include <optional>
#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

namespace fpkcheck::sweep {

/// Largest map_distance() between a problem and a point of the validity map that counts as nearby.
inline constexpr double kNearbyDistance = 1;
/// Least number of points of the validity map for the assessment of a method. If fewer points are
/// nearby, the assessment uses the closest points at any distance.
inline constexpr std::size_t kMinNearbyPoints = 4;

/// The results of a method at the points closest to a problem. Only points at which the method was
/// tried are used: all such points within kNearbyDistance, and at least kMinNearbyPoints points.
struct NearbyMethodResults {
  std::string id;
  std::size_t points = 0, ok = 0;
  std::size_t underestimated = 0;  ///< points with MappedResult::underestimated and L1 > accuracy
  std::optional<double> worst_l1 = {};  ///< over the densities: `ok` or `inaccurate`
  double seconds = 0;                   ///< median
  /// Whether the method is expected to be sufficiently accurate. At each of the points used the
  /// method had status `ok`, and the L1 distance plus the error estimate of the reference was below
  /// the accuracy. There are at least kMinNearbyPoints points, and the closest point is within
  /// kNearbyDistance.
  bool promised = false;
};

/// A recommendation of methods for a problem, derived from a validity map. The recommendation is no
/// guarantee, since the map has no data between its points.
struct Advice {
  MapCoordinates coordinates;
  double accuracy;
  double nearest_distance;        ///< distance of the closest point; infinite where no
                                  ///< point has the same impulse law and relative mean
  std::size_t nearby_points = 0;  ///< number of points within kNearbyDistance
  /// The results of all methods. The methods with `promised` come first, by increasing time, except
  /// for the first method: the first method is the most accurate of all methods that take at most
  /// 1.5 times as long as the fastest method.
  std::vector<NearbyMethodResults> methods{};

  bool is_outside_map() const { return nearest_distance > kNearbyDistance; }
  /// The results of the methods with `promised`; the recommended method comes first.
  std::vector<NearbyMethodResults> promised_methods() const;
};

/// Recommends methods for a problem.
/// @param accuracy largest acceptable L1 error of p(y) and p(y')
Advice recommend_methods(const problem::Problem& problem, double accuracy, const ValidityMap& map);

/// Recommends methods for a problem with the given map coordinates.
Advice recommend_methods(const MapCoordinates& coordinates, double accuracy,
                         const ValidityMap& map);

}  // namespace fpkcheck::sweep
