#include "control_variates/result.hpp"

#include <utility>

namespace fpkcheck::control_variates {

Result make_result(const ControlSetup& setup, mcs::Result simulation) {
  const auto streams = std::exchange(simulation.summary.deposits, {});
  const Eigen::MatrixXd generator = generator_means(setup, streams);
  FunctionalEstimates estimates = estimate_functionals(setup, generator, streams);
  const SimulationChecks judged = check_simulation(setup, generator, streams, estimates);
  return {.estimates = std::move(estimates),
          .checks = judged,
          .simulation = std::move(simulation),
          .backward_means = setup.backward_means};
}

}  // namespace fpkcheck::control_variates
