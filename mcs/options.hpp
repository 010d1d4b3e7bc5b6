#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/description.hpp"
#include "mcs/deposit/deposit.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

/// Monte Carlo simulation of the impact system, paper (1)-(2), in wall coordinates
/// (problem/walls.hpp). The paper's domain is y >= 0. Other problems have no, one or two walls,
/// other forces, other damping and Gaussian noise. The simulation uses no transformation of the
/// variables, no density equation and no code of the other solvers.
namespace fpkcheck::mcs {

using problem::Equation;

/// Progress of a simulation.
struct Progress {
  double fraction;  ///< estimated fraction of the simulation that is complete
  /// Expected L1 sampling errors of p(y) and p(y') if the simulation ended now, as in
  /// Solution::sampling of the result. Empty if this process simulates a part of the streams only.
  std::optional<double> y_l1{}, ydot_l1{};
};

/// Distribution of a simulation over several processes. Each process advances a part of the
/// streams.
struct ProcessGroup {
  int part = 0, parts = 1;
  /// Function that sends the streams of this process to the first process.
  /// @param serialised_streams serialised streams of this process; ignored in the first process
  /// @return in the first process the streams of each other process, in the order of the processes;
  /// in the other processes empty
  std::function<std::vector<std::string>(const std::string& serialised_streams)> gather = {};
};

/// Options of a simulation. An empty optional means the default.
struct Options {
  /// Excitation: `kf` for the impulses, paper (3), or `white` for Gaussian white noise of the same
  /// mean and intensity.
  Equation equation = Equation::kf;
  /// Simulated time, summed over all streams, rounded up to whole rounds. Default: 1.6e6 decay
  /// times of the slowest mode of equivalent linearisation (2/c_eq below critical damping). `tails`
  /// takes 1/32 of this time and `controlled` 1/8; `samples` or `target_error` takes 1e4 times this
  /// time as a limit. A default time that needs more than some seconds is shortened, yet reaches
  /// `accuracy` if about a minute suffices (simulation/simulation_plan.cpp).
  std::optional<double> time{};
  /// Required effective samples of y'^2 (Summary::effective_samples).
  std::optional<double> samples{};
  /// Required error: the largest of the relative standard errors of E[y^2] and E[y'^2] and of the
  /// expected L1 sampling errors of the marginals.
  std::optional<double> target_error{};
  /// Tolerance for the 99 % quantiles of the L1 sampling errors of p(y) and p(y'). A solution with
  /// a larger quantile has the status `inaccurate`.
  double accuracy = 0.02;
  std::uint64_t seed = 1;  ///< below 2^63
  /// Number of threads. Default: one per processor. The results are independent of this number.
  std::optional<int> threads{};
  /// Number of independent realisations, 8 .. 4096. The differences between realisations give the
  /// confidence intervals.
  int streams = 128;
  /// Longest Taylor step, in radians of the highest frequency that the energy permits; at most 1.2.
  /// Default: 0.9.
  std::optional<double> step{};
  /// Interval between the kicks that approximate white noise, in radians, at most 0.5. For the
  /// paper's oscillator the frequency of equivalent linearisation defines the radians, and the
  /// default is 0.05. For other oscillators (NoiseKicks) the mean frequency and the damping
  /// together define the radians, and the default is 0.2 or, at strong impact losses, 0.05
  /// (simulation/simulation_plan.cpp).
  std::optional<double> white_step{};
  /// Splits trajectories at high energies (ImportanceSplitting), to resolve densities down to 1e-8
  /// of their peak and beyond.
  bool tails = false;
  /// Reduces the variance by control variates, for `kf` without `tails`. control_variates::solve()
  /// implements this option with solutions of the backward equation. mcs::solve() returns the plain
  /// estimates.
  bool controlled = false;

  // The members below are no command-line options and are not written to files.

  /// Bin edges of the histogram, increasing, y_edges from 0. Default: 140 bins each over 0 .. 7
  /// sigma_1 and +-7 sigma_2 of equivalent linearisation.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
  /// Grid on which samples are deposited (Summary::deposits), for `kf` without `tails` only. All
  /// other results are independent of this grid.
  std::optional<DepositGrid> deposit{};
  /// Checkpoint file, written every half minute and at the end; if empty, no checkpoint is written.
  /// If the path cannot be written, the simulation does not begin. Later write errors are reported
  /// to `warn`.
  std::string checkpoint{};
  /// Checkpoint file to resume from; if empty, the simulation begins anew. The result equals that
  /// of an uninterrupted run, bit for bit.
  std::string resume{};
  /// Callback for the progress, called after every round. An exception of the callback ends the
  /// simulation and leaves solve().
  std::function<void(const Progress&)> progress{};
  /// Callback for a stop request, called after every round. If the callback returns true, the
  /// simulation ends and the result uses the completed rounds.
  std::function<bool()> stop{};
  /// Callback for warnings: called immediately, with one line, for each difficulty that does not
  /// affect the result. Summary::warnings holds the same lines.
  std::function<void(const std::string&)> warn{};
  /// Processes among which the streams are divided. The first process returns the result, bit for
  /// bit the same for any number of processes. Several processes need `time` and permit no
  /// checkpoints.
  ProcessGroup team{};
};

/// Description of the options with their names on the command line and in files.
const base::Description<Options>& description();

/// @throws InputError in one line: the option, its value and the allowed range
void validate(const Options& options);

/// Id of the solution that solve() computes with these options: "mcs" or "mcs-white".
std::string id(const Options& options);

/// Identity (id, label, method) of the solution that solve() computes with these options.
transform::SolutionIdentity identity(const Options& options);

/// Default options except for those that determine the solution id. Empty if no solution of the
/// simulation has this id.
std::optional<Options> options_of(std::string_view id);

}  // namespace fpkcheck::mcs
