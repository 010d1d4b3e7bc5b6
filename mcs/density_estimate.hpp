#pragma once

#include "mcs/simulation.hpp"
#include "mcs/stream_weights.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// Probabilities below the edges of the bins of a variable, of each stream.
/// @return shape (streams, edges)
std::vector<std::vector<double>> cumulative(const Simulation& simulation,
                                            transform::Variable variable);

/// A marginal with what chance does to it.
struct MarginalEstimate {
  transform::Marginal marginal;
  double sampling_l1 = 0;  ///< expected L1 distance to the exact one
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
