#include "control_variates/result.hpp"

#include <utility>

namespace fpkcheck::control_variates {

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

}  // namespace fpkcheck::control_variates
