#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/option_description.hpp"
#include "mcs/deposit/sample_deposit.hpp"
#include "problem/equation_and_impact_condition.hpp"
#include "transform/solution_identity.hpp"

/// Monte Carlo simulation of the impact system, paper (1)-(2), in wall coordinates
/// (problem/walls.hpp), with forces, damping, walls and Gaussian noise beyond the paper as
/// extensions. The Monte Carlo simulation uses no transformation of the variables, no density
/// equation and no code of other solvers.
namespace fpkcheck::mcs {

using problem::DensityEquation;

struct SimulationProgress {
  double fraction;  ///< fraction of the simulation that is complete, estimated
  /// Expected L1 sampling errors of the densities p(y) and p(y') if the simulation ended now; empty
  /// with control variates, and in a process that simulates only a part of the trajectory streams
  std::optional<double> y_l1{}, ydot_l1{};
};

/// Distribution of a simulation over several processes; each process advances a part of the
/// trajectory streams.
struct SimulationProcessGroup {
  int part = 0, parts = 1;
  /// Function that each process calls to send its trajectory streams to the first process.
  /// @param serialised_streams streams of the calling process; ignored in the first process
  /// @return in the first process, the trajectory streams of all other processes, in the order of
  /// the processes; in other processes, an empty vector
  std::function<std::vector<std::string>(const std::string& serialised_streams)> gather = {};
};

struct SimulationOptions {
  /// Excitation of the simulation, which is `kf` for the impulses, paper (3), or `white` for
  /// Gaussian white noise with the mean and the intensity of the impulses
  DensityEquation equation = DensityEquation::kf;
  /// Simulated time, summed over all trajectory streams, rounded up to whole rounds. The default
  /// simulated time is 1.6e6 decay times of the slowest mode of equivalent linearisation; below
  /// critical damping a decay time is 2/c_eq with the equivalent damping c_eq. The options `tails`
  /// and `controlled` divide the default simulated time by 32. With the options `samples` or
  /// `target_error` the limit of the simulated time is 1e4 times the default simulated time. A
  /// default simulated time that needs more than a few seconds of computing time is shortened; the
  /// option `accuracy` permits up to about a minute of computing time
  /// (simulation/simulation_plan.cpp).
  std::optional<double> time{};
  /// Required number of effectively independent samples of the squared velocity y'^2
  /// (SimulationSummary::effective_samples)
  std::optional<double> samples{};
  /// Required error of the simulation: upper limit of the relative standard errors of E[y^2] and
  /// E[y'^2] and of the expected L1 sampling errors of the marginals
  std::optional<double> target_error{};
  /// Tolerance for the 99 % quantiles of the L1 sampling errors of the densities p(y) and p(y'); a
  /// solution whose quantiles exceed the tolerance has the status `inaccurate`
  double accuracy = 0.02;
  std::uint64_t seed = 1;  ///< seed of the random numbers, below 2^63
  /// Number of threads, which does not change the results; the default is one thread per processor
  std::optional<int> threads{};
  /// Number of independent realisations, 8 .. 4096; their differences give confidence intervals
  int streams = 128;
  /// Longest time step of the Taylor series, in radians of the highest frequency that the energy of
  /// the oscillator permits; at most 1.2, default 0.9
  std::optional<double> step{};
  /// Interval between the kicks that approximate white noise, in radians, at most 0.5. For the
  /// paper's oscillator the frequency of equivalent linearisation converts time to radians, and the
  /// default kick interval is 0.05 radians. For other oscillators the mean frequency and the
  /// damping convert time to radians, and the default kick interval is 0.2 radians, or 0.05 radians
  /// at strong impact losses, under multiplicative noise, and for forces that jump in the velocity.
  std::optional<double> white_step{};
  /// Whether trajectories are split at high energies (ImportanceSplitting), to resolve densities of
  /// 1e-8 of the peak density and less.
  bool tails = false;
  /// Whether control variates reduce the variance, for impulses (`kf`) without the option `tails`.
  /// Only control_variates::simulate_with_control_variates() implements the option `controlled`;
  /// mcs::simulate_stationary_density() returns the estimates without control variates.
  bool controlled = false;

  // The following members are no command-line options and are not written to files.

  /// Increasing bin edges of the histogram; y_edges begin at 0. By default the histogram has 140
  /// bins of y over 0 .. 7 sigma_1 and 140 bins of y' over +-7 sigma_2, with the standard
  /// deviations sigma_1 of y and sigma_2 of y' from equivalent linearisation.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
  /// Spline grid on which the samples are deposited (SimulationSummary::deposits), only for
  /// impulses (`kf`) without the option `tails`; the grid changes no other result
  std::optional<SampleDepositionGrid> deposit{};
  /// Checkpoint file, written every half minute and at the end of the simulation; if empty, no
  /// checkpoint is written. The simulation does not begin if the checkpoint path cannot be written;
  /// later write errors call the function `warn`.
  std::string checkpoint{};
  /// Checkpoint file from which the simulation resumes, with the result of an uninterrupted run,
  /// bit for bit; if empty, the simulation begins anew
  std::string resume{};
  /// Sampling error at which a simulation of the default simulated time may end early: upper limit
  /// of the errors that `target_error` limits. The simulation takes at least an eighth of the
  /// default simulated time. If the default simulated time does not reach the sampling error, the
  /// status of the solution is unaffected. Ignored with the options `time`, `samples` and
  /// `target_error`, and in a simulation by several processes.
  std::optional<double> sufficient_error{};
  /// Callback for the progress after every round of the simulation; simulate_stationary_density()
  /// does not catch an exception of the callback
  std::function<void(const SimulationProgress&)> progress{};
  /// Callback after every round of the simulation; if `stop` returns true, the simulation ends with
  /// the completed rounds as its result
  std::function<bool()> stop{};
  /// Callback for one-line warnings that do not affect the result; SimulationSummary::warnings
  /// contains all warnings as well
  std::function<void(const std::string&)> warn{};
  /// Processes among which the trajectory streams are divided. The result in the first process does
  /// not depend on the number of processes, bit for bit. A simulation by several processes requires
  /// the option `time` and permits no checkpoints.
  SimulationProcessGroup process_group{};
};

const base::OptionsDescription<SimulationOptions>& solver_option_descriptions();

/// @throws InputError with one line that states the option, its value and the allowed range
void validate(const SimulationOptions& options);

/// Returns the id of the solution that simulate_stationary_density() computes with the given
/// options: "mcs" or "mcs-white".
std::string solution_id(const SimulationOptions& options);

/// Returns the identity (id, label, method) of the solution that simulate_stationary_density()
/// computes with the given options.
transform::SolutionIdentity solution_identity(const SimulationOptions& options);

/// Returns the options with which simulate_stationary_density() computes the solution `id`; empty
/// if `id` is no solution of the simulation.
std::optional<SimulationOptions> options_of(std::string_view id);

}  // namespace fpkcheck::mcs
