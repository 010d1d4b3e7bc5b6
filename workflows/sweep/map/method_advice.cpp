#include "workflows/sweep/map/method_advice.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "numerics/statistics.hpp"

namespace fpkcheck::sweep {
namespace {

struct ValidityMapNeighbour {
  double separation;
  const ValidityMapPoint* point;
};

// Returns the points of the validity map with the impulse law and the relative mean of the problem,
// the closest point first.
std::vector<ValidityMapNeighbour> neighbours_by_distance(const ValidityMapCoordinates& coordinates,
                                                         const ValidityMap& map) {
  std::vector<ValidityMapNeighbour> neighbours;
  for (const auto& point : map.points) {
    const double separation = validity_map_distance(coordinates, point.coordinates);
    if (std::isfinite(separation)) neighbours.push_back({separation, &point});
  }
  std::ranges::stable_sort(neighbours, {}, &ValidityMapNeighbour::separation);
  return neighbours;
}

// Moves the most accurate of those promised methods to the front that take at most 1.5 times as
// long as the fastest promised method. Wall-clock times are accurate to a factor of 1.5.
void move_most_accurate_method_first(std::vector<MethodResultsAtNearbyPoints>& methods) {
  constexpr double kSimilarTimeRatio = 1.5;
  if (methods.empty() || !methods.front().promised) return;
  auto best = methods.begin();
  for (auto one = methods.begin(); one != methods.end() && one->promised; ++one) {
    const bool as_quick = one->seconds <= kSimilarTimeRatio * methods.front().seconds;
    if (as_quick && *one->worst_l1 < *best->worst_l1) best = one;
  }
  std::rotate(methods.begin(), best, best + 1);
}

// The upper bound of the L1 error of a method is the L1 distance from the reference plus the error
// estimate of the reference. For the reference itself the upper bound of the L1 error is the error
// estimate alone.
double l1_error_bound(const ValidityMapResult& method_result, const ValidityMapResult& reference) {
  return *method_result.l1 + (&method_result == &reference ? 0 : *reference.l1);
}

MethodResultsAtNearbyPoints nearby_method_results(
    const std::string& id, std::size_t m, const std::vector<ValidityMapNeighbour>& neighbours,
    double accuracy) {
  MethodResultsAtNearbyPoints found{.id = id};
  std::vector<double> seconds;
  double nearest_distance = std::numeric_limits<double>::infinity();
  bool all_hold = true;
  for (const auto& [separation, point] : neighbours) {
    if (separation > kNearbyDistance && found.points >= kMinNearbyPoints) break;
    const auto& method_result = point->method_results[m];
    if (!method_result) continue;
    nearest_distance = std::min(nearest_distance, separation);
    ++found.points;
    found.ok += method_result->has_status_ok() ? 1 : 0;
    seconds.push_back(method_result->seconds);
    const double off = method_result->l1
                           ? l1_error_bound(*method_result, *point->method_results.back())
                           : std::numeric_limits<double>::infinity();
    all_hold = all_hold && method_result->has_status_ok() && off < accuracy;
    if (method_result->has_status_ok() || method_result->status == transform::Status::inaccurate) {
      found.worst_l1 = std::max(found.worst_l1.value_or(0), method_result->l1.value_or(0));
    }
    if (method_result->underestimated && *method_result->l1 > accuracy) ++found.underestimated;
  }
  if (!seconds.empty()) found.seconds = numerics::median(seconds);
  found.promised =
      all_hold && found.points >= kMinNearbyPoints && nearest_distance <= kNearbyDistance;
  return found;
}

}  // namespace

std::vector<MethodResultsAtNearbyPoints> MethodRecommendation::sufficiently_accurate_methods()
    const {
  std::vector<MethodResultsAtNearbyPoints> found;
  std::ranges::copy_if(methods, std::back_inserter(found), &MethodResultsAtNearbyPoints::promised);
  return found;
}

MethodRecommendation recommend_methods(const ValidityMapCoordinates& coordinates, double accuracy,
                                       const ValidityMap& map) {
  const auto neighbours = neighbours_by_distance(coordinates, map);
  MethodRecommendation advice{.coordinates = coordinates,
                              .accuracy = accuracy,
                              .nearest_distance = neighbours.empty()
                                                      ? std::numeric_limits<double>::infinity()
                                                      : neighbours.front().separation};
  advice.nearby_points = static_cast<std::size_t>(std::ranges::count_if(
      neighbours, [](const auto& one) { return one.separation <= kNearbyDistance; }));
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    auto found = nearby_method_results(map.methods[m], m, neighbours, accuracy);
    if (found.points > 0) advice.methods.push_back(std::move(found));
  }
  std::ranges::stable_sort(advice.methods, {}, [](const MethodResultsAtNearbyPoints& one) {
    return std::tuple(!one.promised, one.seconds);
  });
  move_most_accurate_method_first(advice.methods);
  return advice;
}

MethodRecommendation recommend_methods(const problem::Problem& problem, double accuracy,
                                       const ValidityMap& map) {
  return recommend_methods(validity_map_coordinates(problem), accuracy, map);
}

}  // namespace fpkcheck::sweep
