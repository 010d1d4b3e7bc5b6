#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "mcs/estimate.hpp"
#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Monte Carlo simulation of the impact system itself, paper (1)-(2), on y >= 0: no transformation,
/// no density equation, nothing shared with the other solvers.
namespace fpkcheck::mcs {

/// What drives the oscillator.
enum class Equation {
  kf,    ///< the impulses themselves, paper (3)
  white  ///< Gaussian white noise of the same mean and intensity
};

/// How far a simulation has come.
struct Progress {
  double fraction;  ///< of the way to what was asked for, estimated
  double error;     ///< so far: see Options::target_error
};

/// How to simulate. Zero or empty means automatic.
struct Options {
  Equation equation = Equation::kf;
  /// Simulated time over all streams, rounded up to whole rounds; automatic: 1.6e6 decay times of
  /// the slowest mode of equivalent linearisation (2/c_eq below critical damping), 1/32 of it with
  /// `tails`, and no end where `samples` or `target_error` is given.
  double time = 0;
  /// Effective samples of y'^2 to be reached (Summary::effective_samples).
  double samples = 0;
  /// Error to be reached: the largest of the relative standard errors of E[y^2] and E[y'^2] and
  /// the expected L1 distances of the marginals by chance.
  double target_error = 0;
  std::uint64_t seed = 1;
  /// Automatic: one per processor. The results do not depend on it.
  int threads = 0;
  /// Independent realisations, 8 .. 4096; the intervals come from the differences between them.
  int streams = 128;
  /// Bin edges of the histogram, increasing, y_edges from 0. Automatic: 140 bins each over 0 .. 7
  /// sigma_1 and +-7 sigma_2 of the equivalent linearisation.
  std::vector<double> y_edges{};
  std::vector<double> v_edges{};
  /// Longest Taylor step, in radians of the fastest motion that the energy allows; at most 1.2.
  /// Automatic: 0.9.
  double step = 0;
  /// Time between the kicks that stand for white noise, in radians of equivalent linearisation; at
  /// most 0.5. Automatic: 0.05.
  double white_step = 0;
  /// Splits trajectories that reach high energies (Splitting), to resolve densities down to 1e-8 of
  /// their peak and beyond.
  bool tails = false;
  /// File to write the state to twice a minute and in the end; empty for none.
  std::string checkpoint{};
  /// File of a checkpoint to go on from; empty for none. The result is the same, bit for bit, as
  /// without the interruption.
  std::string resume{};
  /// Told how far it has come, after every round. It may throw to stop the simulation; what it
  /// throws leaves simulate().
  std::function<void(const Progress&)> progress{};
  /// Asked after every round; true ends the simulation, and what was reached is the result.
  std::function<bool()> stop{};
};

/// @throws InputError on one line: the option, its value and what is allowed
void validate(const Options& options);

/// The id of the solution that the options lead to: "mcs" or "mcs-white".
std::string id(const Options& options);

/// Standard errors, in the units of what they belong to.
struct StandardErrors {
  transform::Moments moments;
  double energy_residual = 0;
};

/// What was done and how much it may be trusted.
struct Summary {
  double time = 0;  ///< simulated, over all streams, without the burn-in
  std::uint64_t samples = 0;
  double sampling_interval = 0;
  /// Var(y'^2) / SE^2 with the plain standard error, that without weights: how many independent
  /// draws of the stationary density tell as much of E[y'^2].
  double effective_samples = 0;
  double effective_samples_y2 = 0;  ///< the same of E[y^2]
  /// What the weights gain: plain variance of the estimate over the variance reached.
  double variance_reduction_y2 = 1;
  double variance_reduction_v2 = 1;
  StandardErrors standard_errors;
  /// Power that the impulses happened to bring beyond its expectation, relative to lambda E[Y^2]/2,
  /// and its standard error. The weights take it out of the results; being far from 0 in standard
  /// errors it would tell of impulses that do not follow their law.
  double excess_power = 0;
  double excess_power_error = 0;
  /// Expected L1 distance of a marginal to the exact one by chance: sum over bins of
  /// sqrt(2/pi) * standard error * width.
  double sampling_l1_y = 0;
  double sampling_l1_ydot = 0;
  /// What 99 runs of 100 stay below, by the streams' own scatter.
  double sampling_l1_y_99 = 0;
  double sampling_l1_ydot_99 = 0;
  double outside = 0;  ///< fraction of the samples beyond the histogram
  std::uint64_t seed = 0;
  int threads = 0;
  int streams = 0;
  double step = 0;           ///< radians, Options::step
  double kick_interval = 0;  ///< white noise: time between kicks
  double burn_in = 0;        ///< of each stream
  Estimate impact_rate;      ///< impacts per unit time, int |v| p(0, v) dv over v < 0
  std::uint64_t impulses = 0;
  std::uint64_t flights = 0;  ///< Taylor polynomials
  std::uint64_t rounds = 0;
  bool interrupted = false;  ///< by Options::stop
  /// E[y^p y'^q], p + q <= 4, in the order of kPowers.
  std::vector<Estimate> joint_moments;
  std::vector<Quantile> y_quantiles, v_quantiles;
  std::vector<LevelRate> crossings, peaks;
  std::vector<double> thresholds;  ///< energies of the splitting
  /// Standard errors of the joint histogram's averages, row-major.
  std::vector<double> joint_standard_errors;
};

/// A simulated density and how it came about.
struct Result {
  /// Method "mcs", equation "kf" or "white" (id "mcs", "mcs-white"), the joint histogram as a
  /// GridDensity, and the marginals of y and y' on the same edges with 95 % intervals. Normalised
  /// by all samples: `mass` is 1 minus what fell outside the histogram. Moments come from the
  /// samples, not from the histogram.
  transform::Solution solution;
  Summary summary;
};

/// Simulates `options.streams` independent realisations, each from the equivalent-linearisation
/// Gaussian folded to y >= 0 and past a burn-in of 20 decay times of
/// the slowest mode, and averages over them with the weights
/// of StreamWeights. The same seed gives the same result, bit for bit, for any number of threads,
/// of lanes and of interruptions. A simulation that ends before what was asked for is reached has
/// the status not_converged.
/// @throws InputError as validate(), and for checkpoints that cannot be read or written
Result simulate(const problem::Problem& problem, const Options& options);

/// The members that summary.json has for the method "mcs", in the contract's names.
nlohmann::ordered_json to_json(const Summary& summary);

/// The options as asked for; null where automatic. The histogram's edges are those of
/// marginals.csv.
nlohmann::ordered_json to_json(const Options& options);

/// The options that to_json wrote. What it leaves out (edges, files, listeners) is as by default.
/// @throws InputError naming the field that is missing, unknown or of the wrong type
Options options_from_json(const nlohmann::ordered_json& json);

}  // namespace fpkcheck::mcs
