#include "mcs/estimate/stream_averages.hpp"

#include <algorithm>
#include <utility>

#include "mcs/estimate/stream_weights.hpp"

namespace fpkcheck::mcs {

double moment(const Simulation& simulation, const StreamRecord& record, int p, int q) {
  const auto place = std::ranges::find(kPowers, std::pair{p, q}) - kPowers.begin();
  return record.powers[static_cast<std::size_t>(place)] / simulation.stream_samples();
}

double mean_of(const Simulation& simulation, const StreamRecord& record,
               const problem::Polynomial& g) {
  double mean = g.coefficient(0);
  for (std::size_t n = 1; n <= g.degree(); ++n) {
    if (g.coefficient(n) == 0) continue;
    mean += g.coefficient(n) * moment(simulation, record, static_cast<int>(n), 0);
  }
  return mean;
}

std::vector<double> moments(const Simulation& simulation, int p, int q) {
  return each(simulation.streams(),
              [&](const StreamRecord& record) { return moment(simulation, record, p, q); });
}

std::vector<double> excess_powers(const Simulation& simulation) {
  // Impulses come independently of the motion before them, so that their work, Excitation::work,
  // has the expectation lambda int (E[Y] E[v] + E[Y^2]/2) dt; and E[v] = 0, since int v dt is the
  // change of y, which impacts leave alone.
  const double expected = simulation.plan().excitation.work;
  return each(simulation.streams(), [&](const StreamRecord& record) {
    return record.work / simulation.stream_time() - expected;
  });
}

double effective_samples(const Simulation& simulation, int p, int q) {
  const auto [mean, error] = plain_estimate(moments(simulation, p, q));
  const double second = plain_estimate(moments(simulation, 2 * p, 2 * q)).mean;
  return (second - mean * mean) / (error * error);
}

}  // namespace fpkcheck::mcs
