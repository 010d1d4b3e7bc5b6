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

/// Monte Carlo simulation of the impact system itself, paper (1)-(2), in its frame (problem/frame.hpp):
/// y >= 0 in the paper, and with any walls or none, forces, damping and Gaussian noise: no transformation,
/// no density equation, nothing shared with the other solvers.
namespace fpkcheck::mcs {

using problem::Equation;

/// How far a simulation has come.
struct Progress {
  double fraction;  ///< of the way to what was asked for, estimated
  /// Expected L1 error of p(y) and p(y') by chance so far, as Solution::sampling states of the result;
  /// nothing where this process has a part of the streams only.
  std::optional<double> y_l1{}, ydot_l1{};
};

/// A simulation that several processes share: each moves a part of the streams.
struct Team {
  int part = 0, parts = 1;
  /// Brings what the others have simulated to the first process.
  /// @param own what this one has; not looked at in the first one
  /// @return in the first one: what each of the others has, in their order; in the others nothing
  std::function<std::vector<std::string>(const std::string& own)> gather = {};
};

/// How to simulate. Nothing means automatic.
struct Options {
  /// What drives the oscillator: `kf`, the impulses themselves, paper (3), or `white`, Gaussian
  /// white noise of the same mean and intensity.
  Equation equation = Equation::kf;
  /// Simulated time over all streams, rounded up to whole rounds; automatic: 1.6e6 decay times of
  /// the slowest mode of equivalent linearisation (2/c_eq below critical damping), 1/32 of it with
  /// `tails`, 1/8 with `controlled`, and no end where `samples` or `target_error` is given. Less
  /// where that would take more than some seconds, but enough for `accuracy` if that takes a
  /// minute or so (simulation/durations.hpp).
  std::optional<double> time{};
  /// Effective samples of y'^2 to be reached (Summary::effective_samples).
  std::optional<double> samples{};
  /// Error to be reached: the largest of the relative standard errors of E[y^2] and E[y'^2] and
  /// the expected L1 distances of the marginals by chance.
  std::optional<double> target_error{};
  /// Largest L1 error of p(y) and of p(y') by chance, in 99 runs of 100, of a solution that is ok.
  double accuracy = 0.02;
  std::uint64_t seed = 1;  ///< below 2^63
  /// Automatic: one per processor. The results do not depend on it.
  std::optional<int> threads{};
  /// Independent realisations, 8 .. 4096; the intervals come from the differences between them.
  int streams = 128;
  /// Longest Taylor step, in radians of the fastest motion that the energy allows; at most 1.2.
  /// Automatic: 0.9.
  std::optional<double> step{};
  /// Time between the kicks that stand for white noise, in radians of equivalent linearisation; at
  /// most 0.5. Automatic: 0.05. Of other oscillators than the paper's (GeneralKicks): radians of the
  /// mean frequency and the damping together; automatic: 0.2.
  std::optional<double> white_step{};
  /// Splits trajectories that reach high energies (Splitting), to resolve densities down to 1e-8 of
  /// their peak and beyond.
  bool tails = false;
  /// Takes the noise out by control functions, where there are such: for `kf` without `tails`. By
  /// control_variates::solve, where the simulation and the backward equation meet; mcs::solve, which
  /// knows no equation, gives the plain estimates.
  bool controlled = false;

  // What follows is no part of the description: it is not in files.

  /// Bin edges of the histogram, increasing, y_edges from 0. Automatic: 140 bins each over 0 .. 7
  /// sigma_1 and +-7 sigma_2 of the equivalent linearisation.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
  /// Where to deposit the samples (Summary::deposits), only for `kf` without `tails`. Nothing else in
  /// the result depends on it.
  std::optional<DepositGrid> deposit{};
  /// File to write the state to twice a minute and in the end; empty for none. One that cannot be
  /// written is refused before anything is solved; later failures are told to `warn`.
  std::string checkpoint{};
  /// File of a checkpoint to go on from; empty for none. The result is the same, bit for bit, as
  /// without the interruption.
  std::string resume{};
  /// Told how far it has come, after every round. It may throw to stop the simulation; what it
  /// throws leaves solve().
  std::function<void(const Progress&)> progress{};
  /// Asked after every round; true ends the simulation, and what was reached is the result.
  std::function<bool()> stop{};
  /// Told at once, in one line, what goes wrong without an effect on the result; Summary::warnings
  /// has the same lines.
  std::function<void(const std::string&)> warn{};
  /// Processes that share the work: the first one has the result, the same bits for any number of
  /// them. They go on for `time`, without checkpoints.
  Team team{};
};

/// The options as files and the command line name them.
const base::Description<Options>& description();

/// @throws InputError on one line: the option, its value and what is allowed
void validate(const Options& options);

/// The id of the solution that the options lead to: "mcs" or "mcs-white".
std::string id(const Options& options);

/// Who the solution is.
transform::Identity identity(const Options& options);

/// The options, all else automatic, whose solution has this id; nothing when there are none.
std::optional<Options> options_of(std::string_view id);

}  // namespace fpkcheck::mcs
