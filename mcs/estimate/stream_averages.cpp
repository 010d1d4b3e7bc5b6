#include "mcs/estimate/stream_averages.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <utility>

namespace fpkcheck::mcs {
namespace {

constexpr std::size_t kEdgesPerLevel = 10;

double sum_above_edge(const std::vector<double>& sums, std::size_t edge) {
  return std::accumulate(sums.begin() + static_cast<std::ptrdiff_t>(edge) + 1, sums.end(), 0.0);
}

template <class CountEvents>
std::vector<RateOfEventsAtLevel> estimate_level_event_rates(const Simulation& simulation,
                                                            const TrajectoryStreamWeights& weights,
                                                            std::size_t first_edge,
                                                            CountEvents count_events) {
  const auto& edges = simulation.plan_of_simulation().y_bins.edges();
  std::vector<RateOfEventsAtLevel> found;
  for (std::size_t k = first_edge; k < edges.size(); k += kEdgesPerLevel) {
    const auto values = statistic_of_each_stream(
        simulation.trajectory_streams(), [&](const TrajectoryStreamStatistics& record) {
          return count_events(record, k) / simulation.simulated_time_per_stream();
        });
    found.push_back({simulation.plan_of_simulation().frame.physical_y(edges[k]),
                     weights.estimate_mean(values)});
  }
  return found;
}

}  // namespace

double moment_in_wall_coordinates(const Simulation& simulation,
                                  const TrajectoryStreamStatistics& record, int p, int q) {
  const auto index =
      std::ranges::find(kRecordedMomentPowers, std::pair{p, q}) - kRecordedMomentPowers.begin();
  return record.powers[static_cast<std::size_t>(index)] / simulation.expected_samples_per_stream();
}

double moment_in_physical_coordinates(const Simulation& simulation,
                                      const TrajectoryStreamStatistics& record, int p, int q) {
  const problem::WallFrame& frame = simulation.plan_of_simulation().frame;
  if (frame.is_identity()) return moment_in_wall_coordinates(simulation, record, p, q);
  // The physical displacement is y = origin + sign x with the wall coordinate x.
  const auto [origin, sign] = std::pair{frame.origin, frame.velocity_sign()};
  double sum = 0, binomial = 1;
  for (int n = 0; n <= p; ++n) {
    const double of_x = n + q == 0 ? 1 : moment_in_wall_coordinates(simulation, record, n, q);
    sum += binomial * std::pow(origin, p - n) * std::pow(sign, n + q) * of_x;
    binomial *= static_cast<double>(p - n) / (n + 1);
  }
  return sum;
}

double mean_of_polynomial_in_y(const Simulation& simulation,
                               const TrajectoryStreamStatistics& record,
                               const numerics::Polynomial& g) {
  assert(g.degree() <= 6);
  const auto power_of_y = [&](std::size_t n) {
    if (n <= kHighestRecordedMomentPower)
      return moment_in_wall_coordinates(simulation, record, static_cast<int>(n), 0);
    return (n == 5 ? record.y5 : record.y6) / simulation.expected_samples_per_stream();
  };
  double mean = g.coefficient(0);
  for (std::size_t n = 1; n <= g.degree(); ++n) {
    if (g.coefficient(n) != 0) mean += g.coefficient(n) * power_of_y(n);
  }
  return mean;
}

std::vector<double> moment_per_stream(const Simulation& simulation, int p, int q) {
  return statistic_of_each_stream(simulation.trajectory_streams(),
                                  [&](const TrajectoryStreamStatistics& record) {
                                    return moment_in_physical_coordinates(simulation, record, p, q);
                                  });
}

MomentEstimates estimate_moments(const Simulation& simulation,
                                 const TrajectoryStreamWeights& weights) {
  using transform::Moments;
  MomentEstimates estimates;
  const auto set = [&](double Moments::*moment, int p, int q) {
    const MeanEstimate e = weights.estimate_mean(moment_per_stream(simulation, p, q));
    estimates.means.*moment = e.mean;
    estimates.standard_errors.*moment = e.standard_error;
  };
  set(&Moments::y1, 1, 0);
  set(&Moments::y2, 2, 0);
  set(&Moments::y4, 4, 0);
  set(&Moments::v1, 0, 1);
  set(&Moments::v2, 0, 2);
  set(&Moments::v4, 0, 4);
  return estimates;
}

std::vector<double> excess_impulse_power_per_stream(const Simulation& simulation) {
  // Each impulse is independent of the motion before the impulse, so that the work of the impulses
  // (ImpulseProcess::work) has the expectation lambda int (E[Y] E[v] + E[Y^2]/2) dt. In this
  // expectation E[v] = 0, since int v dt is the change of y and impacts do not change y.
  const double expected = simulation.plan_of_simulation().excitation.work;
  return statistic_of_each_stream(
      simulation.trajectory_streams(), [&](const TrajectoryStreamStatistics& record) {
        return record.work / simulation.simulated_time_per_stream() - expected;
      });
}

double effective_sample_count(const Simulation& simulation, int p, int q) {
  const auto [mean, error] = estimate_unweighted_mean(moment_per_stream(simulation, p, q));
  const double second = estimate_unweighted_mean(moment_per_stream(simulation, 2 * p, 2 * q)).mean;
  return (second - mean * mean) / (error * error);
}

std::vector<RateOfEventsAtLevel> estimate_upcrossing_rates(const Simulation& simulation,
                                                           const TrajectoryStreamWeights& weights) {
  return estimate_level_event_rates(simulation, weights, kEdgesPerLevel,
                                    [](const TrajectoryStreamStatistics& record, std::size_t k) {
                                      return sum_above_edge(record.peaks, k) -
                                             sum_above_edge(record.troughs, k);
                                    });
}

std::vector<RateOfEventsAtLevel> estimate_peak_rates(const Simulation& simulation,
                                                     const TrajectoryStreamWeights& weights) {
  return estimate_level_event_rates(simulation, weights, 0,
                                    [](const TrajectoryStreamStatistics& record, std::size_t k) {
                                      return sum_above_edge(record.peaks, k);
                                    });
}

}  // namespace fpkcheck::mcs
