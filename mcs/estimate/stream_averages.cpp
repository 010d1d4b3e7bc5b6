#include "mcs/estimate/stream_averages.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mcs/estimate/stream_weights.hpp"

namespace fpkcheck::mcs {

double moment(const Simulation& simulation, const StreamRecord& record, int p, int q) {
  const auto index = std::ranges::find(kPowers, std::pair{p, q}) - kPowers.begin();
  return record.powers[static_cast<std::size_t>(index)] / simulation.stream_samples();
}

namespace {

double power_of_y(const Simulation& simulation, const StreamRecord& record, int n) {
  if (n <= static_cast<int>(kHighestPower)) return moment(simulation, record, n, 0);
  return (n == 5 ? record.y5 : record.y6) / simulation.stream_samples();
}

}  // namespace

double physical_moment(const Simulation& simulation, const StreamRecord& record, int p, int q) {
  const problem::Frame& frame = simulation.plan().frame;
  if (frame.is_identity()) return moment(simulation, record, p, q);
  // y^p = (origin + sign x)^p
  const auto [origin, sign] = std::pair{frame.origin, frame.sign()};
  double sum = 0, binomial = 1;
  for (int n = 0; n <= p; ++n) {
    const double of_x = n + q == 0 ? 1 : moment(simulation, record, n, q);
    sum += binomial * std::pow(origin, p - n) * std::pow(sign, n + q) * of_x;
    binomial *= static_cast<double>(p - n) / (n + 1);
  }
  return sum;
}

double polynomial_mean(const Simulation& simulation, const StreamRecord& record,
                       const numerics::Polynomial& g) {
  double mean = g.coefficient(0);
  for (std::size_t n = 1; n <= g.degree(); ++n) {
    if (g.coefficient(n) == 0) continue;
    mean += g.coefficient(n) * power_of_y(simulation, record, static_cast<int>(n));
  }
  return mean;
}

std::vector<double> stream_moments(const Simulation& simulation, int p, int q) {
  return value_per_stream(simulation.streams(), [&](const StreamRecord& record) {
    return physical_moment(simulation, record, p, q);
  });
}

std::vector<double> excess_powers(const Simulation& simulation) {
  // Impulses are independent of the motion before them. Their work (Excitation::work) has the
  // expectation lambda int (E[Y] E[v] + E[Y^2]/2) dt. E[v] = 0, since int v dt is the change of y
  // and impacts do not change y.
  const double expected = simulation.plan().excitation.work;
  return value_per_stream(simulation.streams(), [&](const StreamRecord& record) {
    return record.work / simulation.stream_time() - expected;
  });
}

double effective_sample_count(const Simulation& simulation, int p, int q) {
  const auto [mean, error] = plain_estimate(stream_moments(simulation, p, q));
  const double second = plain_estimate(stream_moments(simulation, 2 * p, 2 * q)).mean;
  return (second - mean * mean) / (error * error);
}

}  // namespace fpkcheck::mcs
