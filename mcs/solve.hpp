#pragma once

#include "mcs/options.hpp"
#include "mcs/summary.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::problem {
struct Problem;
}

namespace fpkcheck::mcs {

/// A simulated density and how it came about.
struct Result {
  /// The joint histogram as a GridDensity, and the marginals of y and y' on the same edges with 95
  /// % intervals. Normalised by all samples: `mass` is 1 minus what fell outside the histogram.
  /// Moments come from the samples, not from the histogram. The expected L1 distance of a marginal
  /// to the exact one by chance is the sum over bins of sqrt(2/pi) * standard error * width.
  transform::Solution solution;
  Summary summary;
};

/// Simulates `options.streams` independent realisations, each from the equivalent-linearisation
/// Gaussian folded to y >= 0 and past a burn-in of 20 decay times of the slowest mode, and averages
/// over them with the weights of StreamWeights. Of any other oscillator than the paper's they begin by
/// the averaged law (GeneralStart), with each well its mass. Problems come in their frame
/// (problem/frame.hpp): densities, marginals and atoms are in its coordinates; moments, quantiles and
/// levels are physical. The same seed gives the same result, bit for bit,
/// for any number of threads, of lanes and of interruptions. A simulation that ends before what was
/// asked for is reached has the status not_converged, and so has one whose burn-in is below 5 decay
/// times (BurnInLimit). White noise at a restitution at
/// which impacts accumulate (problem/inelastic_collapse.hpp) is not simulated: failed, without a
/// density.
/// @throws InputError as validate(), for springs that Oscillator refuses, for a checkpoint that
///         cannot be read, and for one that could never be written
Result solve(const problem::Problem& problem, const Options& options);

/// Makes an ok simulation `inaccurate` whose error by chance, in 99 runs of 100, is larger in L1 than
/// Options::accuracy. solve() does so but for `controlled`, whose smooth estimates come later.
void require_accuracy(const Options& options, transform::Solution& solution);

/// What solve() asks of options and problem before it begins, but for the files of a checkpoint.
/// @throws InputError as solve()
void require_solvable(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::mcs
