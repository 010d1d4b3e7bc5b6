#pragma once

#include <vector>

#include "mcs/plan.hpp"
#include "mcs/stream.hpp"
#include "mcs/stream_weights.hpp"
#include "transform/marginal.hpp"

namespace fpkcheck::mcs {

/// A marginal on the bins of the plan with 95 % intervals, and its sampling error.
struct MarginalEstimate {
  transform::Marginal marginal;
  /// Expected L1 distance to the exact marginal: sum over bins of sqrt(2/pi) * standard error *
  /// width.
  double sampling_l1 = 0;
};

/// The marginal of y or y' from the streams' histograms; samples count whatever the other variable.
/// @param effective_samples bounds the density in bins that no sample has fallen into
MarginalEstimate estimate_marginal(const std::vector<StreamRecord>& records, const Plan& plan,
                                   const StreamWeights& weights, transform::Variable variable,
                                   double effective_samples);

/// The joint density over the cells of the histogram, normalised by all samples.
transform::GridDensity estimate_joint_density(const std::vector<StreamRecord>& records,
                                              const Plan& plan, const StreamWeights& weights);

}  // namespace fpkcheck::mcs
