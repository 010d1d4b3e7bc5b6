#include "mcs/solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "base/input_error.hpp"
#include "base/process/stopwatch.hpp"
#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/kick_interval_error.hpp"
#include "mcs/estimate/stream_averages.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/checkpoint.hpp"
#include "mcs/simulation/simulation.hpp"
#include "mcs/simulation_runs.hpp"
#include "problem/balances.hpp"
#include "problem/problem_features.hpp"

namespace fpkcheck::mcs {
namespace {

using transform::StateVariable;

void set_moments(const Simulation& simulation, const TrajectoryStreamWeights& weights,
                 SimulationResult& result) {
  auto& [solution, summary] = result;
  for (const auto& [p, q] : kRecordedMomentPowers) {
    summary.joint_moments.push_back(weights.estimate_mean(moment_per_stream(simulation, p, q)));
  }
  const MomentEstimates estimates = estimate_moments(simulation, weights);
  solution.moments = estimates.means;
  solution.standard_errors->moments = estimates.standard_errors;
}

double mean_damping_power(const problem::System& system, const Simulation& simulation,
                          const TrajectoryStreamStatistics& r) {
  // In the stationary state the restoring force has the mean power 0.
  if (!system.has_polynomial_force()) return r.force_v / simulation.expected_samples_per_stream();
  const auto& c = system.damping_polynomial();
  return c.coefficient(0) * moment_in_wall_coordinates(simulation, r, 0, 2) +
         c.coefficient(1) * moment_in_wall_coordinates(simulation, r, 1, 2) +
         c.coefficient(2) * moment_in_wall_coordinates(simulation, r, 2, 2) +
         system.rayleigh_coefficient() * moment_in_wall_coordinates(simulation, r, 0, 4);
}

/// Returns the energy lost per unit time at a wall, from
/// TrajectoryStreamStatistics::left_wall_squared_impact_speeds or right_wall_squared_impact_speeds.
double impact_loss_rate(const std::optional<problem::Wall>& wall, const Simulation& simulation,
                        double energy_sum) {
  const double rate = energy_sum / simulation.simulated_time_per_stream();
  if (wall && !wall->has_constant_restitution()) return rate;
  return problem::impact_energy_loss_rate(wall, problem::ImpactCondition::exact, rate);
}

/// Returns the momentum per unit time from a wall, from TrajectoryStreamStatistics::left_momentum
/// or right_momentum.
double impact_momentum_rate(const std::optional<problem::Wall>& wall, const Simulation& simulation,
                            double momentum_sum) {
  const double rate = momentum_sum / simulation.simulated_time_per_stream();
  if (wall && !wall->has_constant_restitution()) return rate;
  return problem::impact_momentum_rate(wall, rate);
}

problem::PowerBalanceTerms power_balance_terms(const problem::Problem& problem,
                                               const Simulation& simulation,
                                               const TrajectoryStreamStatistics& r) {
  const problem::System& system = problem.system;
  problem::PowerBalanceTerms terms{
      .mean_velocity = moment_in_wall_coordinates(simulation, r, 0, 1),
      .mean_square_velocity = moment_in_wall_coordinates(simulation, r, 0, 2),
      .left_impact_loss =
          impact_loss_rate(system.left_wall(), simulation, r.left_wall_squared_impact_speeds),
      .right_impact_loss =
          impact_loss_rate(system.right_wall(), simulation, r.right_wall_squared_impact_speeds),
      .mean_damping_power = mean_damping_power(system, simulation, r)};
  if (problem.noise_factor) {
    terms.mean_square_noise_factor = r.noise_factor / simulation.expected_samples_per_stream();
  }
  if (problem.impulse_factor) {
    terms.mean_square_impulse_factor = r.impulse_factor / simulation.expected_samples_per_stream();
  }
  return terms;
}

void estimate_impacts(const problem::Problem& problem, const Simulation& simulation,
                      const TrajectoryStreamWeights& weights, SimulationResult& result) {
  result.summary.impacts_accumulate = simulation.plan_of_simulation().has_contact_atoms;
  result.summary.impact_rate = weights.estimate_mean(statistic_of_each_stream(
      simulation.trajectory_streams(),
      [&](const auto& r) { return r.impacts / simulation.simulated_time_per_stream(); }));
  const auto estimate_of_streams = [&](auto of) {
    return weights.estimate_mean(statistic_of_each_stream(
        simulation.trajectory_streams(),
        [&](const auto& r) { return of(power_balance_terms(problem, simulation, r)); }));
  };
  // The weighted mean over the trajectory streams estimates only quantities that are linear in the
  // averages of the streams. Under state-dependent noise or impulses only the difference of input
  // power and dissipated power is linear in the averages of the streams.
  MeanEstimate residual{};
  if (problem.noise_factor || problem.impulse_factor) {
    residual = estimate_of_streams([&](const problem::PowerBalanceTerms& terms) {
      const auto [input, dissipated] = problem::power_balance(problem, terms);
      return input - dissipated;
    });
    const double input = estimate_of_streams([&](const problem::PowerBalanceTerms& terms) {
                           return problem::power_balance(problem, terms).input;
                         }).mean;
    residual.mean /= input;
    residual.standard_error /= input;
  } else {
    residual = estimate_of_streams([&](const problem::PowerBalanceTerms& terms) {
      return problem::power_balance_residual(problem, terms);
    });
  }
  result.solution.energy_residual = residual.mean;
  result.solution.standard_errors->energy_residual = residual.standard_error;
}

/// Sets the residuals of the virial and momentum balances. The residuals of the virial and momentum
/// balances are linear in the averages of the trajectory streams, and therefore have no sampling
/// bias. The residual of each balance is divided by the scale of the balance, averaged over all
/// streams.
void estimate_balances(const problem::Problem& problem, const Simulation& simulation,
                       const TrajectoryStreamWeights& weights, SimulationSummary& summary) {
  const problem::System& system = problem.system;
  // If a formula states the force, mean force and mean virial include the damping force.
  const auto mean_force = [&](const TrajectoryStreamStatistics& r) {
    return system.has_polynomial_force()
               ? mean_of_polynomial_in_y(simulation, r, system.restoring_force())
               : r.force / simulation.expected_samples_per_stream();
  };
  const auto mean_virial = [&](const TrajectoryStreamStatistics& r) {
    return system.has_polynomial_force()
               ? mean_of_polynomial_in_y(simulation, r,
                                         system.restoring_force().multiplied_by_argument())
               : r.force_y / simulation.expected_samples_per_stream();
  };
  const SimulatedOscillator& o = simulation.plan_of_simulation().oscillator;
  const auto right_momentum = [&](const TrajectoryStreamStatistics& r) {
    return impact_momentum_rate(system.right_wall(), simulation, r.right_momentum);
  };
  // Mean contact force on the mass at rest at a wall; 0 if the stationary law has no atoms. The
  // sums of the momentum changes at impacts already include accumulating impacts.
  const auto contact_force_at_rest = [&](const TrajectoryStreamStatistics& r) {
    return (o.left.contact_force * r.rest_left - o.right.contact_force * r.rest_right) /
           simulation.expected_samples_per_stream();
  };
  // Virial of the contact force that holds the mass at rest on the right wall, y = b.
  const auto virial_at_rest = [&](const TrajectoryStreamStatistics& r) {
    return o.right.position * std::max(o.right.contact_force, 0.0) * r.rest_right /
           simulation.expected_samples_per_stream();
  };
  const auto set = [&](auto balance, std::optional<double> transform::BalanceResiduals::*member) {
    const auto difference = weights.estimate_mean(statistic_of_each_stream(
        simulation.trajectory_streams(),
        [&](const auto& r) { return balance(r).left_minus_right_side(); }));
    const double scale =
        weights
            .estimate_mean(statistic_of_each_stream(
                simulation.trajectory_streams(), [&](const auto& r) { return balance(r).scale; }))
            .mean;
    summary.balances.*member = difference.mean / scale;
    summary.balance_errors.*member = difference.standard_error / scale;
  };
  set(
      [&](const TrajectoryStreamStatistics& r) {
        return problem::virial_balance(
            problem, {.mean_displacement = moment_in_wall_coordinates(simulation, r, 1, 0),
                      .mean_square_velocity = moment_in_wall_coordinates(simulation, r, 0, 2),
                      .mean_virial = mean_virial(r) + virial_at_rest(r),
                      .right_impact_momentum = right_momentum(r),
                      .mean_y_cubed_velocity = moment_in_wall_coordinates(simulation, r, 1, 3)});
      },
      &transform::BalanceResiduals::virial);
  set(
      [&](const TrajectoryStreamStatistics& r) {
        return problem::momentum_balance(
            problem, {.mean_force = mean_force(r),
                      .left_impact_momentum =
                          impact_momentum_rate(system.left_wall(), simulation, r.left_momentum),
                      .right_impact_momentum = right_momentum(r),
                      .mean_cubed_velocity = moment_in_wall_coordinates(simulation, r, 0, 3),
                      .contact_momentum_rate = contact_force_at_rest(r)});
      },
      &transform::BalanceResiduals::momentum);
}

/// Estimates the difference between the power of the drawn impulses and the power by the impulse
/// law, without the weights of the trajectory streams.
void estimate_excess_power(const Simulation& simulation, SimulationSummary& summary) {
  const auto excess = estimate_unweighted_mean(excess_impulse_power_per_stream(simulation));
  const double input = simulation.plan_of_simulation().excitation.power;
  summary.excess_power = excess.mean / input;
  summary.excess_power_error = excess.standard_error / input;
}

/// Sets the effective numbers of samples of the unweighted means, and the factors by which the
/// weights of the trajectory streams (TrajectoryStreamWeights) reduce the variances.
void estimate_efficiency(const Simulation& simulation, SimulationResult& result) {
  const auto reduction = [&](int p, int q, double error) {
    const double ratio =
        estimate_unweighted_mean(moment_per_stream(simulation, p, q)).standard_error / error;
    return ratio * ratio;
  };
  auto& solution = result.solution;
  auto& summary = result.summary;
  const auto& errors = solution.standard_errors->moments;
  summary.effective_samples = effective_sample_count(simulation, 0, 2);
  summary.effective_samples_y2 = effective_sample_count(simulation, 2, 0);
  summary.variance_reduction_y2 = reduction(2, 0, errors.y2);
  summary.variance_reduction_v2 = reduction(0, 2, errors.v2);
}

double outside_fraction(const Simulation& simulation, const TrajectoryStreamWeights& weights) {
  const SimulationPlan& plan = simulation.plan_of_simulation();
  const auto beyond = statistic_of_each_stream(
      simulation.trajectory_streams(), [&](const TrajectoryStreamStatistics& record) {
        const auto rows = record.histogram.row_sums();
        const double all = std::accumulate(rows.begin(), rows.end(), 0.0);
        double inside = 0;
        for (std::size_t i = 1; i <= plan.y_bins.bin_count(); ++i) {
          for (std::size_t j = 1; j <= plan.v_bins.bin_count(); ++j)
            inside += record.histogram(i, j);
        }
        return all > 0 ? (all - inside) / all : 0.0;
      });
  return std::max(0.0, weights.estimate_mean(beyond).mean);
}

void estimate_atoms(const Simulation& simulation, const TrajectoryStreamWeights& weights,
                    transform::Solution& solution) {
  if (!simulation.plan_of_simulation().has_contact_atoms) return;
  const auto add = [&](const SimulatedWall& wall, double TrajectoryStreamStatistics::*rest) {
    if (!(wall.has_impact_losses() && wall.contact_force > 0)) return;
    const MeanEstimate p = weights.estimate_mean(statistic_of_each_stream(
        simulation.trajectory_streams(), [&](const TrajectoryStreamStatistics& r) {
          return r.*rest / simulation.expected_samples_per_stream();
        }));
    solution.atoms.push_back({.y = wall.position,
                              .probability = p.mean,
                              .standard_error = p.standard_error,
                              .error_estimate = {}});
  };
  add(simulation.plan_of_simulation().oscillator.left, &TrajectoryStreamStatistics::rest_left);
  add(simulation.plan_of_simulation().oscillator.right, &TrajectoryStreamStatistics::rest_right);
}

void estimate_densities(const Simulation& simulation, const TrajectoryStreamWeights& weights,
                        SimulationResult& result) {
  auto& solution = result.solution;
  auto& summary = result.summary;
  const auto marginal = [&](StateVariable variable) {
    auto estimate = estimate_marginal(simulation, weights, variable, summary.effective_samples);
    solution.estimated_marginals.emplace_back(variable, std::move(estimate.marginal));
    return l1_sampling_error(estimate.errors);
  };
  const L1SamplingError y = marginal(StateVariable::y), ydot = marginal(StateVariable::ydot);
  solution.sampling = transform::MarginalSamplingErrors{
      .y = y.expected, .ydot = ydot.expected, .y_99 = y.quantile_99, .ydot_99 = ydot.quantile_99};
  auto joint = estimate_joint_density(simulation, weights);
  estimate_atoms(simulation, weights, solution);
  solution.mass = transform::mass(joint.density);
  for (const auto& atom : solution.atoms) solution.mass += atom.probability;
  solution.density = std::move(joint.density);
  summary.joint_standard_errors = std::move(joint.standard_errors);
  summary.outside_fraction = outside_fraction(simulation, weights);
  // If the stationary law has atoms, the distribution function of y has jumps, which the
  // interpolation of quantiles does not resolve.
  if (solution.atoms.empty()) {
    summary.y_quantiles = estimate_quantiles(simulation, weights, StateVariable::y);
    summary.v_quantiles = estimate_quantiles(simulation, weights, StateVariable::ydot);
  }
  summary.crossings = estimate_upcrossing_rates(simulation, weights);
  // Rates of peaks are not estimated in two cases: white noise causes infinitely many maxima of y,
  // and in a mirrored frame the counted maxima are minima of y.
  const SimulationPlan& plan = simulation.plan_of_simulation();
  if (!plan.kicks.is_acting() && !plan.frame.mirrored) {
    summary.peaks = estimate_peak_rates(simulation, weights);
  }
}

void fill_summary(const Simulation& simulation, SimulationSummary& summary) {
  const SimulationPlan& plan = simulation.plan_of_simulation();
  summary.time = simulation.simulated_time_per_stream() * plan.streams;
  summary.samples = simulation.sampling_round_count() * plan.samples_per_round *
                    static_cast<std::uint64_t>(plan.streams);
  summary.sampling_interval = plan.sampling_interval;
  summary.seed = plan.seed;
  summary.threads = plan.threads;
  summary.streams = plan.streams;
  summary.step = plan.step;
  if (plan.excitation.arrivals == ImpulseProcess::Arrivals::even) {
    summary.kick_interval = plan.excitation.interval;
  }
  if (plan.kicks.is_acting()) {
    summary.kick_interval = plan.kicks.longest_interval;
  }
  summary.burn_in = plan.burn_in;
  summary.rounds = simulation.sampling_round_count();
  for (const TrajectoryStream& stream : simulation.trajectory_streams()) {
    summary.impulses += stream.record.impulses;
    summary.flights += stream.record.flights;
  }
}

std::vector<DepositedSumsOfTrajectory> stream_deposits(const Simulation& simulation) {
  std::vector<DepositedSumsOfTrajectory> all;
  for (const TrajectoryStream& stream : simulation.trajectory_streams()) {
    const TrajectoryStreamStatistics& record = stream.record;
    all.push_back({.sums = record.deposit,
                   .samples = record.samples,
                   .time = simulation.simulated_time_per_stream(),
                   .impacts = record.impacts,
                   .powers = record.powers});
  }
  return all;
}

/// @param unreached_goal_reason reason why the requested accuracy was not reached, or empty
void set_status(const SimulationPlan& plan, const SimulationOptions& options,
                const SimulationSummary& summary, transform::Solution& solution,
                const std::string& unreached_goal_reason) {
  constexpr std::uint64_t kFewestImpulses = 10;  // least number of impulses per stream
  const transform::Moments& m = solution.moments;
  const bool finite = std::isfinite(m.y1 + m.y2 + m.y4 + m.v1 + m.v2 + m.v4);
  solution.status =
      unreached_goal_reason.empty() ? transform::Status::ok : transform::Status::not_converged;
  solution.reason = unreached_goal_reason;
  const auto streams = static_cast<std::uint64_t>(summary.streams);
  if (plan.short_burn_in_cause != ShortBurnInCause::none) {
    solution.status = transform::Status::not_converged;
    solution.reason = short_burn_in_reason(plan, options);
  }
  const bool has_impulses = std::isfinite(plan.excitation.interval);
  if (has_impulses && summary.impulses < kFewestImpulses * streams) {
    solution.status = transform::Status::not_converged;
    solution.reason =
        fmt::format("only {} impulses in {} streams: too few for standard errors; increase --time",
                    summary.impulses, summary.streams);
  }
  if (!finite || !(solution.mass > 0)) {
    solution.status = transform::Status::failed;
    solution.reason =
        "no finite density: trajectories left the histogram or the range of floating-point "
        "numbers; rescale the problem";
  }
}

void fill_result(const problem::Problem& problem, const Simulation& simulation,
                 SimulationResult& result) {
  const TrajectoryStreamWeights weights(excess_impulse_power_per_stream(simulation));
  result.solution.standard_errors.emplace();
  set_moments(simulation, weights, result);
  estimate_impacts(problem, simulation, weights, result);
  estimate_balances(problem, simulation, weights, result.summary);
  estimate_excess_power(simulation, result.summary);
  estimate_efficiency(simulation, result);
  estimate_densities(simulation, weights, result);
  fill_summary(simulation, result.summary);
}

void require_options_for_processes(const SimulationOptions& options) {
  if (options.process_group.parts == 1) return;
  const auto refuse = [](bool given, const char* option) {
    if (!given) return;
    throw InputError(fmt::format(
        "mcs {} with several processes: all processes simulate the same --time; omit the option",
        option));
  };
  refuse(options.target_error.has_value(), "--target-error");
  refuse(options.samples.has_value(), "--samples");
  refuse(!options.checkpoint.empty(), "--checkpoint");
  refuse(!options.resume.empty(), "--resume");
}

/// Collects the trajectory streams of all processes in the first process.
/// @return whether the calling process is the first process
bool gather_streams(const SimulationProcessGroup& process_group, Simulation& simulation) {
  if (process_group.parts == 1) return true;
  std::ostringstream own;
  if (process_group.part > 0) simulation.save_streams_of_this_process(own);
  const auto others = process_group.gather(own.str());
  for (std::size_t k = 0; k < others.size(); ++k) {
    std::istringstream part(others[k]);
    simulation.load_streams_of_process(part, static_cast<int>(k) + 1);
  }
  return process_group.part == 0;
}

/// Runs a simulation with twice the interval between noise kicks, for half of the simulated time.
/// @return whether the simulation with the doubled interval is complete; false after a stop request
bool run_with_doubled_kick_interval(const Simulation& simulation, const SimulationOptions& options,
                                    Simulation& doubled) {
  doubled.keep_streams_of_process(options.process_group.part, options.process_group.parts);
  doubled.run_burn_in();
  const std::uint64_t rounds = (simulation.sampling_round_count() + 1) / 2;
  while (doubled.sampling_round_count() < rounds) {
    if (is_simulation_stop_requested(options)) return false;
    doubled.simulate_and_sample_one_round();
  }
  return true;
}

}  // namespace

void require_accuracy(const SimulationOptions& options, transform::Solution& solution) {
  const auto& sampling = transform::smallest_known_sampling_errors(solution);
  if (!solution.has_status_ok() || !sampling) return;
  const double y = sampling->y_99.value_or(0), ydot = sampling->ydot_99.value_or(0);
  const transform::ErrorEstimate bias = solution.error.value_or(transform::ErrorEstimate{});
  if (y + bias.y_l1 <= options.accuracy && ydot + bias.ydot_l1 <= options.accuracy) return;
  solution.status = transform::Status::inaccurate;
  if (!solution.error) {
    solution.reason = fmt::format(
        "sampling errors above the accuracy {:g}: their 99 % quantiles are L1 {:.2g} in p(y) and "
        "{:.2g} in p(y'); increase --time",
        options.accuracy, y, ydot);
    return;
  }
  const bool is_y_worse = y + bias.y_l1 > ydot + bias.ydot_l1;
  const double by_chance = is_y_worse ? y : ydot,
               by_interval = is_y_worse ? bias.y_l1 : bias.ydot_l1;
  solution.reason = fmt::format(
      "error above the accuracy {:g}: L1 {:.2g} in {}, the sum of the 99 % quantile {:.2g} of the "
      "sampling error and {:.2g} by the interval between noise kicks; {}",
      options.accuracy, by_chance + by_interval, is_y_worse ? "p(y)" : "p(y')", by_chance,
      by_interval, by_interval > by_chance ? "reduce --white-step" : "increase --time");
}

void require_valid_simulation(const problem::Problem& problem, const SimulationOptions& options) {
  [[maybe_unused]] const SimulationPlan plan = make_simulation_plan(problem, options);
  require_options_for_processes(options);
}

SimulationResult simulate_stationary_density(const problem::Problem& problem,
                                             const SimulationOptions& options) {
  const base::Stopwatch stopwatch;
  SimulationResult result;
  auto& solution = result.solution;
  auto& summary = result.summary;
  solution.identity = solution_identity(options);
  const SimulationPlan plan = make_simulation_plan(problem, options);
  require_options_for_processes(options);
  // After inelastic collapse evenly spaced kicks would lift the mass off the wall after each kick
  // interval, so that the simulated density would not converge as the kick interval tends to 0.
  solution.reason = problem::inelastic_collapse_reason(problem, options.equation);
  if (!solution.reason.empty()) return result;
  CheckpointWriter checkpoints(options.checkpoint, [&](const std::string& warning) {
    summary.warnings.push_back(warning);
    if (options.warn) options.warn(warning);
  });
  std::optional<ImportanceSplitting> splitting;
  if (options.tails) splitting = choose_splitting_thresholds(problem, plan);
  const ImportanceSplitting* splits = splitting ? &*splitting : nullptr;
  Simulation simulation(problem, plan, splits);
  simulation.keep_streams_of_process(options.process_group.part, options.process_group.parts);
  const std::string fingerprint = mcs::simulation_fingerprint(problem, plan, splits);
  if (options.resume.empty()) {
    simulation.run_burn_in();
  } else {
    read_checkpoint(options.resume, fingerprint, simulation);
  }
  auto [unreached_goal_reason, interrupted] =
      simulate_until_goal(simulation, options, checkpoints, fingerprint);

  const auto doubled_plan = kick_interval_affects_stationary_density(plan)
                                ? plan_with_doubled_kick_interval(problem, plan)
                                : std::nullopt;
  std::optional<Simulation> doubled;
  if (doubled_plan && !interrupted) {
    doubled.emplace(problem, *doubled_plan);
    if (!run_with_doubled_kick_interval(simulation, options, *doubled)) {
      interrupted = true;
      unreached_goal_reason =
          "interrupted: the error of the interval between noise kicks is incomplete";
      doubled.reset();
    }
  }
  const bool has_all_streams = gather_streams(options.process_group, simulation);
  if (doubled) gather_streams(options.process_group, *doubled);
  if (!has_all_streams) {
    solution.reason = "the first process has the result";
    return result;
  }

  fill_result(problem, simulation, result);
  if (doubled) solution.error = estimate_kick_interval_error(solution, *doubled);
  summary.interrupted = interrupted;
  if (plan.deposit) summary.deposits = stream_deposits(simulation);
  if (splitting) {
    summary.thresholds = splitting->thresholds();
    if (summary.thresholds.empty() && unreached_goal_reason.empty()) {
      unreached_goal_reason =
          "no splitting thresholds: too few impulses in the pilot runs; omit --tails, or "
          "increase --streams";
    }
  }
  set_status(plan, options, summary, solution, unreached_goal_reason);
  if (!options.controlled) require_accuracy(options, solution);
  solution.metrics = solver_metrics(summary);
  solution.seconds = stopwatch.seconds();
  return result;
}

}  // namespace fpkcheck::mcs
