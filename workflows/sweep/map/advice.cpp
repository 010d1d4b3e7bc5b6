#include "workflows/sweep/map/advice.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

namespace fpkcheck::sweep {
namespace {

struct Neighbour {
  double away;
  const MappedPoint* point;
};

// The points of the map with the same impulse law and relative mean, the closest first.
std::vector<Neighbour> neighbours_of(const Place& place, const ValidityMap& map) {
  std::vector<Neighbour> neighbours;
  for (const auto& point : map.points) {
    const double away = distance(place, point.place);
    if (std::isfinite(away)) neighbours.push_back({away, &point});
  }
  std::ranges::stable_sort(neighbours, {}, &Neighbour::away);
  return neighbours;
}

// Moves the most accurate of the methods that take about as long as the fastest to the front:
// wall-clock times are no more accurate than that.
void put_best_first(std::vector<MethodNearby>& methods) {
  constexpr double kAboutAsLong = 1.5;
  if (methods.empty() || !methods.front().promised) return;
  auto best = methods.begin();
  for (auto one = methods.begin(); one != methods.end() && one->promised; ++one) {
    const bool as_quick = one->seconds <= kAboutAsLong * methods.front().seconds;
    if (as_quick && *one->worst_l1 < *best->worst_l1) best = one;
  }
  std::rotate(methods.begin(), best, best + 1);
}

double median(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::ranges::nth_element(numbers, middle);
  return *middle;
}

// Upper bound of a result's error: L1 to the reference plus the error estimate of the reference.
// For the reference itself its error estimate alone.
double off_by(const MappedAnswer& answer, const MappedAnswer& reference) {
  return *answer.l1 + (&answer == &reference ? 0 : *reference.l1);
}

MethodNearby nearby(const std::string& id, std::size_t m, const std::vector<Neighbour>& neighbours,
                    double accuracy) {
  MethodNearby found{.id = id};
  std::vector<double> seconds;
  double nearest = std::numeric_limits<double>::infinity();
  bool all_hold = true;
  for (const auto& [away, point] : neighbours) {
    if (away > kNear && found.points >= kFewestNear) break;
    const auto& answer = point->answers[m];
    if (!answer) continue;
    nearest = std::min(nearest, away);
    ++found.points;
    found.ok += answer->is_ok() ? 1 : 0;
    seconds.push_back(answer->seconds);
    const double off = answer->l1 ? off_by(*answer, *point->answers.back())
                                  : std::numeric_limits<double>::infinity();
    all_hold = all_hold && answer->is_ok() && off < accuracy;
    if (answer->is_ok() || answer->status == transform::Status::inaccurate) {
      found.worst_l1 = std::max(found.worst_l1.value_or(0), answer->l1.value_or(0));
    }
    if (answer->misstated && *answer->l1 > accuracy) ++found.misstated;
  }
  if (!seconds.empty()) found.seconds = median(seconds);
  found.promised = all_hold && found.points >= kFewestNear && nearest <= kNear;
  return found;
}

}  // namespace

std::vector<MethodNearby> Advice::promised() const {
  std::vector<MethodNearby> found;
  std::ranges::copy_if(methods, std::back_inserter(found), &MethodNearby::promised);
  return found;
}

Advice advice(const Place& place, double accuracy, const ValidityMap& map) {
  const auto neighbours = neighbours_of(place, map);
  Advice advice{.place = place,
                .accuracy = accuracy,
                .nearest = neighbours.empty() ? std::numeric_limits<double>::infinity()
                                              : neighbours.front().away};
  advice.near = static_cast<std::size_t>(
      std::ranges::count_if(neighbours, [](const auto& one) { return one.away <= kNear; }));
  for (std::size_t m = 0; m < map.methods.size(); ++m) {
    auto found = nearby(map.methods[m], m, neighbours, accuracy);
    if (found.points > 0) advice.methods.push_back(std::move(found));
  }
  std::ranges::stable_sort(advice.methods, {}, [](const MethodNearby& one) {
    return std::tuple(!one.promised, one.seconds);
  });
  put_best_first(advice.methods);
  return advice;
}

Advice advice(const problem::Problem& problem, double accuracy, const ValidityMap& map) {
  return advice(place_of(problem), accuracy, map);
}

}  // namespace fpkcheck::sweep
