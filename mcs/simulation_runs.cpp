#include "mcs/simulation_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "problem/problem.hpp"
#include "problem/undamped_orbits.hpp"

namespace fpkcheck::mcs {

namespace {

constexpr double kRarest = 1e-10;
// least number of visits of trajectory branches to energies above a splitting threshold
constexpr double kFewestVisits = 1000;
constexpr int kMostPilots = 30;
constexpr double kPilotTime = 0.5;  // shortest pilot run, in durations of the burn-in
// Least number of impulses in a pilot simulation, summed over all trajectory streams
constexpr double kPilotImpulses = 8 * kFewestVisits;
constexpr double kLargestEnergy = 1e4;  // largest energy of the energy bins, in units of sigma_2^2

// Returns the potential energy, with minimum 0, for the energy thresholds of importance splitting.
// For a Duffing oscillator at a wall the potential energy is the potential of the spring. For other
// oscillators the potential energy includes the potential of the mean impulse force, without which
// the potential energy may have no lower bound.
numerics::Polynomial splitting_potential(const problem::Problem& problem,
                                         const SimulationPlan& plan) {
  if (plan.oscillator.is_duffing_at_wall()) return problem.system.potential();
  const problem::UndampedOrbits orbits(problem);
  auto coefficients = orbits.potential().polynomial_or_null()->coefficients();
  coefficients[0] -= orbits.lowest_potential();
  return numerics::Polynomial(coefficients);
}

struct SamplingErrors {
  double y_l1, ydot_l1;
  double target;  ///< largest of the sampling errors that SimulationOptions::target_error limits
};

SamplingErrors current_sampling_errors(const Simulation& simulation) {
  const TrajectoryStreamWeights weights(excess_impulse_power_per_stream(simulation));
  const auto l1 = [&](transform::StateVariable variable) {
    return expected_l1_error(estimate_marginal(simulation, weights, variable, 1).errors);
  };
  SamplingErrors now{.y_l1 = l1(transform::StateVariable::y),
                     .ydot_l1 = l1(transform::StateVariable::ydot),
                     .target = 0};
  now.target = std::max(now.y_l1, now.ydot_l1);
  for (const auto& [p, q] : {std::pair{2, 0}, std::pair{0, 2}}) {
    const MeanEstimate e = weights.estimate_mean(moment_per_stream(simulation, p, q));
    now.target = std::max(now.target, e.standard_error / e.mean);
  }
  if (!std::isfinite(now.target)) now.target = std::numeric_limits<double>::infinity();
  return now;
}

struct RunProgress {
  double fraction;  ///< fraction of the required work; may exceed 1
  /// Current sampling errors; empty if neither an option nor the caller needs sampling errors
  std::optional<SamplingErrors> errors;
  bool goal_reached;  ///< whether the requested number of samples and error are reached
};

/// Returns whether the simulation may end at the error SimulationOptions::sufficient_error before
/// the end of the default simulated time.
bool can_end_at_sufficient_error(const Simulation& simulation, const SimulationOptions& options) {
  // Shorter simulations would save little time besides the burn-in and the other methods of a run.
  constexpr std::uint64_t kLeastPart = 8;
  return options.sufficient_error && !options.time && !options.samples && !options.target_error &&
         kLeastPart * simulation.sampling_round_count() >= simulation.plan_of_simulation().rounds;
}

RunProgress current_progress(const Simulation& simulation, const SimulationOptions& options) {
  RunProgress now{.fraction = static_cast<double>(simulation.sampling_round_count()) /
                              static_cast<double>(simulation.plan_of_simulation().rounds),
                  .errors = {},
                  .goal_reached = false};
  if (simulation.sampling_round_count() == 0) return now;
  now.goal_reached = options.target_error || options.samples;
  // In a simulation by several processes each process has only a part of the trajectory streams,
  // from which the sampling errors of the complete result cannot be computed.
  if (options.process_group.parts > 1) return now;
  // With control variates the sampling errors are known only at the end of a simulation.
  const bool can_end_early = can_end_at_sufficient_error(simulation, options);
  if (options.target_error || can_end_early || (options.progress && !options.controlled)) {
    now.errors = current_sampling_errors(simulation);
  }
  if (can_end_early) {
    now.fraction =
        std::max(now.fraction, std::pow(*options.sufficient_error / now.errors->target, 2));
    now.goal_reached = now.errors->target <= *options.sufficient_error;
  }
  if (options.target_error) {
    now.fraction = std::max(now.fraction, std::pow(*options.target_error / now.errors->target, 2));
    now.goal_reached = now.goal_reached && now.errors->target <= *options.target_error;
  }
  if (options.samples) {
    const double samples = effective_sample_count(simulation, 0, 2);
    now.fraction = std::max(now.fraction, samples / *options.samples);
    now.goal_reached = now.goal_reached && samples >= *options.samples;
  }
  return now;
}

/// Returns the outcome of the simulation if the simulation must end now; empty if the simulation
/// must continue.
std::optional<SimulationRunOutcome> outcome_if_finished(const Simulation& simulation,
                                                        const SimulationOptions& options,
                                                        const RunProgress& now) {
  if (now.goal_reached) return SimulationRunOutcome{};
  if (simulation.sampling_round_count() >= simulation.plan_of_simulation().rounds) {
    if (!options.target_error && !options.samples) return SimulationRunOutcome{};
    return SimulationRunOutcome{
        .unreached_goal_reason =
            "simulated time too short: samples or target error not reached; increase "
            "--time"};
  }
  if (simulation.sampling_round_count() > 0 && is_simulation_stop_requested(options)) {
    return SimulationRunOutcome{
        .unreached_goal_reason = fmt::format("interrupted: only {:.1f} % of the simulation is "
                                             "complete",
                                             100 * std::min(now.fraction, 1.0)),
        .interrupted = true};
  }
  return std::nullopt;
}

}  // namespace

bool is_simulation_stop_requested(const SimulationOptions& options) {
  return options.process_group.parts == 1 && options.stop && options.stop();
}

ImportanceSplitting choose_splitting_thresholds(const problem::Problem& problem,
                                                const SimulationPlan& plan) {
  const double largest = kLargestEnergy * plan.velocity_deviation * plan.velocity_deviation;
  const numerics::Polynomial potential = splitting_potential(problem, plan);
  SimulationPlan pilot = plan;
  // With the inverted seed, the random numbers of pilot and main simulations are independent.
  pilot.seed = ~plan.seed;
  pilot.samples_per_round =
      static_cast<std::uint64_t>(std::max(kPilotTime * plan.burn_in, kPilotImpulses / plan.streams *
                                                                         plan.excitation.interval) /
                                 plan.sampling_interval) +
      1;
  Simulation simulation(problem, pilot);
  simulation.run_burn_in();
  std::vector<double> thresholds;
  for (int n = 0; n < kMostPilots; ++n) {
    const ImportanceSplitting splitting(potential, thresholds, largest);
    simulation.set_importance_splitting(splitting);
    simulation.simulate_and_sample_one_round();
    std::vector<double> energies(splitting.energy_bins().bin_count() + 2);
    for (const TrajectoryStream& stream : simulation.trajectory_streams()) {
      std::ranges::transform(energies, stream.record.energies, energies.begin(), std::plus{});
    }
    auto next =
        choose_energy_thresholds(splitting.energy_bins(), energies,
                                 kFewestVisits * std::pow(ImportanceSplitting::kCopiesPerSplit,
                                                          -splitting.threshold_count()),
                                 kRarest);
    const bool further = next.size() > thresholds.size();
    if (further || n == 0) thresholds = std::move(next);
    if (!further) break;
  }
  return {potential, thresholds, largest};
}

SimulationRunOutcome simulate_until_goal(Simulation& simulation, const SimulationOptions& options,
                                         CheckpointWriter& checkpoints,
                                         const std::string& fingerprint) {
  checkpoints.write_checkpoint_now(fingerprint, simulation);
  for (bool first = true;; first = false) {
    const RunProgress now = current_progress(simulation, options);
    if (options.progress && !first) {
      SimulationProgress at{.fraction = std::min(now.fraction, 1.0)};
      if (now.errors) {
        at.y_l1 = now.errors->y_l1;
        at.ydot_l1 = now.errors->ydot_l1;
      }
      options.progress(at);
    }
    if (auto end = outcome_if_finished(simulation, options, now)) {
      checkpoints.write_final_checkpoint(fingerprint, simulation);
      return *std::move(end);
    }
    simulation.simulate_and_sample_one_round();
    checkpoints.write_checkpoint_when_due(fingerprint, simulation);
  }
}

}  // namespace fpkcheck::mcs
