#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/options/description.hpp"
#include "mcs/deposit/grid.hpp"
#include "problem/model.hpp"
#include "transform/identity.hpp"

/// Monte Carlo simulation of the impact system, paper (1)-(2), in wall coordinates
/// (problem/frame.hpp). The paper's domain is y >= 0; other problems have any walls or none, other
/// forces, damping and Gaussian noise. The simulation uses no transformation, no density equation
/// and nothing of the other solvers.
namespace fpkcheck::mcs {

using problem::Equation;

/// Progress of a simulation.
struct Progress {
  double fraction;  ///< estimated fraction of the required work
  /// Expected L1 sampling errors of p(y) and p(y') so far, as in Solution::sampling of the result.
  /// Empty where this process simulates a part of the streams only.
  std::optional<double> y_l1{}, ydot_l1{};
};

/// A simulation distributed over several processes: each one advances a part of the streams.
struct Team {
  int part = 0, parts = 1;
  /// Sends the streams of this process to the first process.
  /// @param own streams of this process, serialised; ignored in the first process
  /// @return in the first process: the streams of each other process, in their order; elsewhere
  ///        empty
  std::function<std::vector<std::string>(const std::string& own)> gather = {};
};

/// Options of a simulation. An empty optional stands for the default.
struct Options {
  /// Excitation: `kf`, the impulses, paper (3), or `white`, Gaussian white noise of the same mean
  /// and intensity.
  Equation equation = Equation::kf;
  /// Simulated time, summed over all streams, rounded up to whole rounds. Default: 1.6e6 decay
  /// times of the slowest mode of equivalent linearisation (2/c_eq below critical damping). `tails`
  /// takes 1/32 of this time and `controlled` 1/8; `samples` or `target_error` takes 1e4 times this
  /// time as a limit. A default time that needs more than some seconds is shortened, yet reaches
  /// `accuracy` if about a minute suffices (simulation/durations.hpp).
  std::optional<double> time{};
  /// Required effective samples of y'^2 (Summary::effective_samples).
  std::optional<double> samples{};
  /// Required error: the largest of the relative standard errors of E[y^2] and E[y'^2] and of the
  /// expected L1 sampling errors of the marginals.
  std::optional<double> target_error{};
  /// Tolerance for the 99 % quantiles of the L1 sampling errors of p(y) and p(y'). A solution with
  /// larger ones is `inaccurate`.
  double accuracy = 0.02;
  std::uint64_t seed = 1;  ///< below 2^63
  /// Default: one per processor. The results are independent of the number of threads.
  std::optional<int> threads{};
  /// Independent realisations, 8 .. 4096. Their scatter gives the confidence intervals.
  int streams = 128;
  /// Longest Taylor step, in radians of the highest frequency that the energy permits; at most 1.2.
  /// Default: 0.9.
  std::optional<double> step{};
  /// Interval between the kicks that approximate white noise, at most 0.5. In the paper's class:
  /// radians of equivalent linearisation, default 0.05. Outside that class (GeneralKicks): radians
  /// of the mean frequency and the damping together, default 0.2 or, at strong impact losses, 0.05
  /// (simulation/general_plan.cpp).
  std::optional<double> white_step{};
  /// Splits trajectories at high energies (Splitting), to resolve densities down to 1e-8 of their
  /// peak and beyond.
  bool tails = false;
  /// Reduces the variance by control variates, for `kf` without `tails`. control_variates::solve
  /// implements this option, since it links the backward equation. mcs::solve gives the plain
  /// estimates.
  bool controlled = false;

  // Members without a description: they are not written to files.

  /// Bin edges of the histogram, increasing, y_edges from 0. Default: 140 bins each over 0 .. 7
  /// sigma_1 and +-7 sigma_2 of equivalent linearisation.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
  /// Grid on which samples are deposited (Summary::deposits), for `kf` without `tails` only. All
  /// other results are independent of it.
  std::optional<DepositGrid> deposit{};
  /// Checkpoint file, written every half minute and at the end; empty: none. A path that cannot be
  /// written is refused before the simulation begins. Later write errors are reported to `warn`.
  std::string checkpoint{};
  /// Checkpoint file to resume from; empty: none. The result equals that of an uninterrupted run,
  /// bit for bit.
  std::string resume{};
  /// Called with the progress after every round. An exception of the callback ends the simulation
  /// and leaves solve().
  std::function<void(const Progress&)> progress{};
  /// Called after every round. `true` ends the simulation; the result uses the rounds so far.
  std::function<bool()> stop{};
  /// Called at once, with one line, for each problem that does not affect the result.
  /// Summary::warnings holds the same lines.
  std::function<void(const std::string&)> warn{};
  /// Processes that share the streams. The first process returns the result, with the same bits for
  /// any number of processes. They simulate for `time`, without checkpoints.
  Team team{};
};

/// The options as the command line and files name them.
const base::Description<Options>& description();

/// @throws InputError in one line: the option, its value and the allowed range
void validate(const Options& options);

/// Id of the solution that these options give: "mcs" or "mcs-white".
std::string id(const Options& options);

/// Identity of the solution that these options give.
transform::Identity identity(const Options& options);

/// Options with this solution id and default values otherwise; empty where no options give the id.
std::optional<Options> options_of(std::string_view id);

}  // namespace fpkcheck::mcs
