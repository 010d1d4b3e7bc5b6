#pragma once

#include <vector>

#include "mcs/estimate/stream_weights.hpp"
#include "mcs/simulation/simulation.hpp"
#include "transform/marginal_density.hpp"

namespace fpkcheck::mcs {

/// Contributions of the trajectory streams to the sampling error of each bin probability
/// (TrajectoryStreamWeights::stream_error_contributions), shape (bins, streams).
using BinErrors = std::vector<std::vector<double>>;

/// Returns the expected L1 sampling error of a marginal density, the sum over bins of sqrt(2/pi)
/// times the standard error of the bin probability.
double expected_l1_error(const BinErrors& errors);

struct L1SamplingError {
  double expected = 0;  ///< expected L1 sampling error, from expected_l1_error()
  /// 99 % quantile of the L1 sampling error, including the correlation of neighbouring bins
  double quantile_99 = 0;
};

L1SamplingError l1_sampling_error(const BinErrors& errors);

struct MarginalDensityEstimate {
  transform::Marginal marginal;
  BinErrors errors;
};

/// Returns the marginal density of y or y' in bins, estimated from all samples, with a 95 %
/// confidence interval for each bin.
/// @param effective_samples effective number of samples, which gives the upper confidence limit in
/// a bin without samples
MarginalDensityEstimate estimate_marginal(const Simulation& simulation,
                                          const TrajectoryStreamWeights& weights,
                                          transform::StateVariable variable,
                                          double effective_samples);

struct JointDensityEstimate {
  transform::GridDensity density;
  std::vector<double> standard_errors;  ///< standard errors of the cell averages, row-major
};
JointDensityEstimate estimate_joint_density(const Simulation& simulation,
                                            const TrajectoryStreamWeights& weights);

/// Returns quantiles of y or y' from the distribution function F of the histogram, which is cubic
/// between the bin edges. The 95 % confidence interval of a quantile contains the values x for
/// which F(x) agrees with the probability within the sampling error (Woodruff, JASA 47, 1952).
/// Quantiles outside the bins are omitted.
std::vector<QuantileWithConfidenceInterval> estimate_quantiles(
    const Simulation& simulation, const TrajectoryStreamWeights& weights,
    transform::StateVariable variable);

}  // namespace fpkcheck::mcs
