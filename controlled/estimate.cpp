#include "controlled/estimate.hpp"

#include <future>
#include <utility>

#include "mcs/simulation/plan.hpp"

namespace fpkcheck::controlled {
namespace {

// Radians of the longest flights. At 0.9 their error is 1e-8 of the damping, which is
// 6e-9 of E[y^2] in case 1: more than is left of the noise. At 0.5 it is a hundredth of that.
constexpr double kStep = 0.5;

}  // namespace

Result combined(const Prepared& prepared, mcs::Result simulation) {
  const auto streams = std::exchange(simulation.summary.deposits, {});
  const Eigen::MatrixXd generator = mean_generator(prepared, streams);
  Estimates estimates = combine(prepared, generator, streams);
  const Checks judged = checks(prepared, generator, streams, estimates);
  return {.estimates = std::move(estimates),
          .checks = judged,
          .simulation = std::move(simulation),
          .backward_means = prepared.backward_means};
}

Result estimate(const problem::Problem& problem, const Options& options) {
  const Places where = places(problem, options.cells);
  mcs::Options simulation = options.simulation;
  simulation.deposit = where.grid;
  simulation.step = simulation.step.value_or(kStep);
  const double interval = mcs::make_plan(problem, simulation).sampling_interval;
  auto prepared = std::async(std::launch::async, [&] { return prepare(problem, where, interval); });
  mcs::Result simulated = mcs::solve(problem, simulation);
  return combined(prepared.get(), std::move(simulated));
}

}  // namespace fpkcheck::controlled
