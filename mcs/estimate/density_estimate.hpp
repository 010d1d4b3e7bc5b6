#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// Contributions of the streams to the sampling error of the probability of each bin
/// (StreamWeights::error_contributions), shape (bins, streams).
using BinErrors = std::vector<std::vector<double>>;

/// Expected L1 sampling error of a marginal: sum over bins of sqrt(2/pi) * standard error.
double expected_l1_error(const BinErrors& errors);

/// Distribution of the L1 sampling error of a marginal.
struct L1SamplingError {
  double expected = 0;     ///< expected value, expected_l1_error()
  double quantile_99 = 0;  ///< 99 % quantile, with the correlation of neighbouring bins
};

L1SamplingError l1_sampling_error(const BinErrors& errors);

/// A marginal density and its sampling errors.
struct MarginalEstimate {
  transform::Marginal marginal;
  BinErrors errors;
};

/// Marginal density in bins, from all samples of the variable, with pointwise 95 % intervals.
/// @param effective_samples determines the upper confidence limit in a bin without samples
MarginalEstimate estimate_marginal(const Simulation& simulation, const StreamWeights& weights,
                                   transform::Variable variable, double effective_samples);

/// The joint histogram as a density, with the standard error of each average.
struct JointEstimate {
  transform::GridDensity density;
  std::vector<double> standard_errors;  ///< standard errors of the averages, row-major
};
JointEstimate estimate_joint_density(const Simulation& simulation, const StreamWeights& weights);

/// Quantiles of y or y' from the distribution function F of the histogram, cubic between its edges.
/// The 95 % interval holds the values whose F agrees with the probability within the sampling error
/// (Woodruff, JASA 47, 1952). Quantiles outside the bins are omitted.
std::vector<Quantile> estimate_quantiles(const Simulation& simulation, const StreamWeights& weights,
                                         transform::Variable variable);

}  // namespace fpkcheck::mcs
