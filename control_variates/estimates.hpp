#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control_variates/control_setup.hpp"
#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/summary.hpp"

namespace fpkcheck::control_variates {

/// Two estimates of an expectation: with control variates and without (plain).
struct ControlledAndPlainEstimate {
  mcs::Estimate controlled, plain;
};

/// Estimates of a marginal density, averaged over smooth bins.
struct BinEstimates {
  transform::SmoothBins bins;
  std::vector<ControlledAndPlainEstimate> averages;
  Eigen::MatrixXd covariance;  ///< covariance matrix of the controlled averages
  mcs::L1SamplingError controlled_l1, plain_l1;
};

struct FunctionalEstimates {
  std::vector<ControlledAndPlainEstimate> moments;  ///< moments in the order of kMoments
  BinEstimates y, v;
  /// Half-width of a 95 % confidence interval, in standard errors (Student's t).
  double interval_factor = 0;
};

/// Mean of L A_i B_j in each stream, with the contribution of impacts, of shape (functions,
/// streams). The function A_i B_j is in row i * v.size() + j.
Eigen::MatrixXd generator_means(const ControlSetup& setup,
                                std::span<const mcs::StreamDeposit> streams);

/// Estimates E[f] by the mean of f + L h for every functional, with control function h. The
/// estimate is unbiased for any h. The standard errors are computed from the differences between
/// streams.
FunctionalEstimates estimate_functionals(const ControlSetup& setup,
                                         const Eigen::MatrixXd& generator,
                                         std::span<const mcs::StreamDeposit> streams);

}  // namespace fpkcheck::control_variates
