#include "transform/transient.hpp"

#include <algorithm>
#include <cmath>

namespace fpkcheck::transform {
namespace {

ErrorEstimate absolute_difference(const TransientDensitySnapshot& a,
                                  const TransientDensitySnapshot& b) {
  ErrorEstimate result{.y_l1 = l1_distance(a.y, b.y), .ydot_l1 = l1_distance(a.ydot, b.ydot)};
  for (const auto& [name, symbol, moment, size] : kMoments) {
    result.moments.*moment = std::abs(a.moments.*moment - b.moments.*moment);
  }
  return result;
}

void increase_errors_to(const ErrorEstimate& other, ErrorEstimate& error) {
  error.y_l1 = std::max(error.y_l1, other.y_l1);
  error.ydot_l1 = std::max(error.ydot_l1, other.ydot_l1);
  for (const auto& [name, symbol, moment, size] : kMoments) {
    error.moments.*moment = std::max(error.moments.*moment, other.moments.*moment);
  }
}

}  // namespace

void estimate_errors_by_differences(const std::vector<TransientDensitySnapshot>& less_accurate,
                                    double half_period,
                                    std::vector<TransientDensitySnapshot>& snapshots) {
  const std::size_t count = std::min(less_accurate.size(), snapshots.size());
  std::vector<ErrorEstimate> differences;
  for (std::size_t k = 0; k < count; ++k) {
    differences.push_back(absolute_difference(snapshots[k], less_accurate[k]));
  }
  for (std::size_t k = 0; k < count; ++k) {
    ErrorEstimate& error = snapshots[k].error.emplace(differences[k]);
    for (std::size_t j = 0; j < count; ++j) {
      const bool is_neighbour = j + 1 == k || j == k + 1;
      if (is_neighbour || std::abs(snapshots[j].time - snapshots[k].time) <= half_period) {
        increase_errors_to(differences[j], error);
      }
    }
  }
}

}  // namespace fpkcheck::transform
