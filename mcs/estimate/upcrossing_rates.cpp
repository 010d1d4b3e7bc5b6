#include "mcs/estimate/upcrossing_rates.hpp"

#include <numeric>

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kEdgesPerLevel = 10;  // bin edges per crossing level

double sum_above(const std::vector<double>& sums, std::size_t edge) {
  return std::accumulate(sums.begin() + static_cast<std::ptrdiff_t>(edge) + 1, sums.end(), 0.0);
}

template <class Of>
std::vector<LevelEventRate> level_rates(const Simulation& simulation, const StreamWeights& weights,
                                        std::size_t first, Of of) {
  const auto& edges = simulation.plan().y_bins.edges();
  std::vector<LevelEventRate> found;
  for (std::size_t k = first; k < edges.size(); k += kEdgesPerLevel) {
    const auto values = value_per_stream(simulation.streams(), [&](const StreamRecord& record) {
      return of(record, k) / simulation.stream_time();
    });
    found.push_back({simulation.plan().frame.physical_y(edges[k]), weights.estimate(values)});
  }
  return found;
}

}  // namespace

std::vector<LevelEventRate> estimate_upcrossing_rates(const Simulation& simulation,
                                                      const StreamWeights& weights) {
  return level_rates(simulation, weights, kEdgesPerLevel,
                     [](const StreamRecord& record, std::size_t k) {
                       return sum_above(record.peaks, k) - sum_above(record.troughs, k);
                     });
}

std::vector<LevelEventRate> estimate_peak_rates(const Simulation& simulation,
                                                const StreamWeights& weights) {
  return level_rates(simulation, weights, 0, [](const StreamRecord& record, std::size_t k) {
    return sum_above(record.peaks, k);
  });
}

}  // namespace fpkcheck::mcs
