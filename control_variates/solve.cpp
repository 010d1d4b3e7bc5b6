#include "control_variates/solve.hpp"

#include <chrono>
#include <future>
#include <utility>

#include "backward/generator/normal_equations.hpp"
#include "base/process/stopwatch.hpp"
#include "control_variates/control_variate_solution.hpp"
#include "mcs/simulation/simulation_plan.hpp"
#include "problem/equivalent_linearisation.hpp"

namespace fpkcheck::control_variates {
namespace {

// Longest flight between impulses and impacts in the simulation, in radians of oscillation. Flights
// of 0.9 rad change E[y^2] in case 1 of the paper by the fraction 6e-9, more than the sampling
// error with control variates. Flights of 0.5 rad have a hundred times smaller truncation errors
// than flights of 0.9 rad.
constexpr double kStep = 0.5;

// Largest memory in bytes of the velocity lattices of all streams of the simulation.
constexpr double kMostBytes = 256e6;

// Returns more spline cells for longer simulations, since the fit of 80 x 176 cells takes as long
// as the simulation of about 1e7 samples. With checkpoints the number of spline cells does not
// depend on the simulated time, so that a longer simulation can resume from a checkpoint.
ControlVariateSplineCellCounts choose_spline_cells(const mcs::SimulationPlan& plan,
                                                   const mcs::SimulationOptions& options) {
  if (!options.checkpoint.empty() || !options.resume.empty()) return {};
  constexpr double kFewSamples = 2e5, kManySamples = 1e7;
  const double samples =
      static_cast<double>(plan.rounds) * static_cast<double>(plan.samples_per_round) * plan.streams;
  if (samples < kFewSamples) return {.y = 40, .v = 88};
  return samples < kManySamples ? ControlVariateSplineCellCounts{}
                                : ControlVariateSplineCellCounts{.y = 80, .v = 176};
}

double lattice_bytes(const mcs::SampleDepositionGrid& grid) {
  return static_cast<double>(sizeof(double)) * grid.y_spline_count() * grid.lattice_points;
}

transform::Solution solve_without_control_variates(const problem::Problem& problem,
                                                   const ControlVariateOptions& options,
                                                   const std::string& reason) {
  // Sampling errors that are sufficient for a comparison with other methods, an eighth of the
  // accuracy that the status `ok` requires. The sampling errors after the default simulated time
  // are 5e-4 to 3e-3 in the shipped cases.
  constexpr double kPartOfAccuracy = 1.0 / 8;
  mcs::SimulationOptions plain = options.simulation;
  plain.controlled = false;
  plain.sufficient_error = kPartOfAccuracy * plain.accuracy;
  return with_note_on_missing_control_variates(
      mcs::simulate_stationary_density(problem, plain).solution, reason);
}

}  // namespace

transform::Solution simulate_with_control_variates(const problem::Problem& problem,
                                                   const ControlVariateOptions& options) {
  if (options.simulation.equation != mcs::DensityEquation::kf || options.simulation.tails) {
    return solve_without_control_variates(
        problem, options, "control functions exist for impulses without splitting only");
  }
  if (!problem::has_equivalent_linearisation(problem) || !problem.frame.is_identity()) {
    return solve_without_control_variates(
        problem, options,
        "control functions exist only for one left wall at the equilibrium, constant damping and "
        "impulses");
  }
  const base::Stopwatch stopwatch;
  mcs::SimulationOptions simulation = options.simulation;
  simulation.controlled = true;
  simulation.step = simulation.step.value_or(kStep);
  const mcs::SimulationPlan plan = mcs::make_simulation_plan(problem, simulation);
  const DepositionSplineLayout layout = make_deposition_spline_layout(
      problem, options.cells.value_or(choose_spline_cells(plan, simulation)));
  if (lattice_bytes(layout.grid) * simulation.streams > kMostBytes) {
    return solve_without_control_variates(problem, options,
                                          "impulses this small need too much memory");
  }
  simulation.deposit = layout.grid;
  const auto policy = simulation.threads == 1 ? std::launch::deferred : std::launch::async;
  auto setup = std::async(
      policy, [&] { return make_control_variate_setup(problem, layout, plan.sampling_interval); });
  // With one thread the fit of the control variates precedes the simulation: a stop request during
  // the simulation then does not wait for the fit.
  if (policy == std::launch::deferred) setup.wait();
  if (simulation.progress) {
    simulation.progress = [&](const mcs::SimulationProgress& at) {
      const bool fitted = setup.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
      options.simulation.progress({.fraction = fitted ? at.fraction : 0});
    };
  }
  mcs::SimulationResult simulated = mcs::simulate_stationary_density(problem, simulation);
  transform::Solution solution;
  if (!simulated.solution.density) {
    solution = std::move(simulated.solution);
  } else {
    try {
      // Since setup.get() may throw LeastSquaresFitFailure, the simulation result `simulated` is
      // moved only after setup.get().
      const ControlVariateSetup fitted = setup.get();
      solution = solution_estimated_by_control_variates(
          estimate_and_check_simulation(fitted, std::move(simulated)));
    } catch (const backward::LeastSquaresFitFailure& why) {
      solution = with_note_on_missing_control_variates(std::move(simulated.solution), why.what());
    }
  }
  mcs::require_accuracy(options.simulation, solution);
  solution.seconds = stopwatch.seconds();
  return solution;
}

}  // namespace fpkcheck::control_variates
