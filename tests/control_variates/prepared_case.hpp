#pragma once

#include "control_variates/control_variate_solution.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "paper_cases.hpp"

namespace fpkcheck::tests {

/// A problem with coarse control functions, which several tests share.
struct PreparedCase {
  problem::Problem problem;
  control_variates::ControlVariateSetup setup;

  explicit PreparedCase(problem::Problem p,
                        control_variates::ControlVariateSplineCellCounts cells = {30, 64})
      : problem(std::move(p)),
        setup(control_variates::make_control_variate_setup(
            problem, control_variates::make_deposition_spline_layout(problem, cells),
            mcs::make_simulation_plan(problem, mcs::SimulationOptions{}).sampling_interval)) {}

  mcs::SimulationOptions simulation_options(double time, std::uint64_t seed = 1,
                                            int streams = 64) const {
    mcs::SimulationOptions o{.time = time, .seed = seed, .streams = streams, .step = 0.5};
    o.deposit = setup.deposit_layout.grid;
    return o;
  }
  /// @param simulated simulated problem, which may differ from the problem of the control functions
  control_variates::ControlVariateResult simulate_and_estimate(
      const problem::Problem& simulated, const mcs::SimulationOptions& options) const {
    return control_variates::estimate_and_check_simulation(
        setup, mcs::simulate_stationary_density(simulated, options));
  }
  control_variates::ControlVariateResult simulate_and_estimate(double time, std::uint64_t seed = 1,
                                                               int streams = 64) const {
    return simulate_and_estimate(problem, simulation_options(time, seed, streams));
  }
  /// Returns a copy with all control functions multiplied by a factor.
  PreparedCase with_scaled_control(double factor) const {
    PreparedCase other(*this);
    other.setup.control *= factor;
    return other;
  }
};

inline const PreparedCase& prepared_case_1() {
  static const PreparedCase setup(paper_case(1));
  return setup;
}

inline constexpr double kTrueY2 = 0.3945181772, kTrueV2 = 0.4415122125;  // case 1, error 7e-10

}  // namespace fpkcheck::tests
