#pragma once

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// The errors that chance gives to each bin's probability, StreamWeights::errors: shape (bins,
/// streams).
using BinErrors = std::vector<std::vector<double>>;

/// The expected L1 distance of a marginal from the truth: sum over bins of sqrt(2/pi) * standard
/// error.
double expected_l1(const BinErrors& errors);

/// How far from the truth chance takes a marginal, in L1.
struct SamplingL1 {
  double expected = 0;  ///< expected_l1
  double in_99 = 0;     ///< what 99 runs of 100 stay below: errors of neighbouring bins go together
};

SamplingL1 sampling_l1(const BinErrors& errors);

/// Probabilities below the edges of the bins of a variable, of each stream.
/// @return shape (streams, edges)
std::vector<std::vector<double>> cumulative(const Simulation& simulation,
                                            transform::Variable variable);

/// A marginal with what chance does to it.
struct MarginalEstimate {
  transform::Marginal marginal;
  BinErrors errors;
};

/// A marginal by its bins, from all samples of its variable, with pointwise 95 % intervals.
/// @param effective_samples to bound the density of a bin that no sample fell into
MarginalEstimate estimate_marginal(const Simulation& simulation, const StreamWeights& weights,
                                   transform::Variable variable, double effective_samples);

/// The joint histogram as a density, and the standard error of each of its averages.
struct JointEstimate {
  transform::GridDensity density;
  std::vector<double> standard_errors;  ///< row-major, as the averages
};
JointEstimate estimate_joint_density(const Simulation& simulation, const StreamWeights& weights);

}  // namespace fpkcheck::mcs
