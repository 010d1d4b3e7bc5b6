#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "problem/problem.hpp"
#include "transform/solution.hpp"

/// Monte Carlo simulation of the impact system itself, paper (1)-(2), on y >= 0: no transformation,
/// no density equation, nothing shared with the other solvers.
namespace fpkcheck::mcs {

/// How to simulate. Zero or empty means automatic.
struct Options {
  /// Simulated time over all streams; automatic: 1.2e6 decay times of the slowest mode
  /// of equivalent linearisation (2/c_eq below critical damping).
  double time = 0;
  std::uint64_t seed = 1;
  /// Automatic: one per processor. The results do not depend on it.
  int threads = 0;
  /// Independent realisations, 8 .. 4096; the intervals come from the differences between them.
  int streams = 128;
  /// Bin edges of the histogram, increasing, y_edges from 0. Automatic: 140 bins each over 0 .. 7
  /// sigma_1 and +-7 sigma_2 of the equivalent linearisation.
  std::vector<double> y_edges;
  std::vector<double> v_edges;
  /// Longest Taylor step, in radians of the fastest motion that the energy allows; at most 1.
  /// Automatic: 0.8.
  double step = 0;
  /// Told the fraction done: by the working threads, but never by two at once. It may throw to stop
  /// the simulation; what it throws leaves simulate().
  std::function<void(double fraction)> progress;
};

/// @throws InputError on one line: the option, its value and what is allowed
void validate(const Options& options);

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
  double outside = 0;  ///< fraction of the samples beyond the histogram
  std::uint64_t seed = 0;
  int threads = 0;
  int streams = 0;
  double step = 0;         ///< radians, Options::step
  double burn_in = 0;      ///< of each stream
  double impact_rate = 0;  ///< impacts per unit time
  std::uint64_t impulses = 0;
};

/// A simulated density and how it came about.
struct Result {
  /// Method "mcs", equation "kf", the joint histogram as a GridDensity, and the marginals of y and
  /// y' on the same edges with 95 % intervals. Normalised by all samples: `mass` is 1 minus what
  /// fell outside the histogram. Moments come from the samples, not from the histogram.
  transform::Solution solution;
  Summary summary;
};

/// Simulates `options.streams` independent realisations, each from the equivalent-linearisation
/// Gaussian folded to y >= 0 and past a burn-in of 20 decay times of
/// the slowest mode, and averages over them with the weights
/// of StreamWeights. The same seed gives the same result, bit for bit, for any number of threads
/// (on processors and with compilers that round alike).
/// @throws InputError as validate()
Result simulate(const problem::Problem& problem, const Options& options);

/// The members that summary.json has for the method "mcs", in the contract's names.
nlohmann::ordered_json to_json(const Summary& summary);

/// The options as asked for; null where automatic. The histogram's edges are those of
/// marginals.csv.
nlohmann::ordered_json to_json(const Options& options);

}  // namespace fpkcheck::mcs
