#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control_variates/control_setup.hpp"
#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/estimate.hpp"
#include "mcs/summary.hpp"

namespace fpkcheck::control_variates {

/// Estimate of an expectation with control variates, and the plain estimate.
struct EstimatePair {
  mcs::Estimate controlled, plain;
};

/// Estimates of a density in smooth bins.
struct BinEstimates {
  transform::SmoothBins bins;
  std::vector<EstimatePair> averages;
  Eigen::MatrixXd covariance;  ///< of the controlled averages
  mcs::SamplingL1 controlled_l1, plain_l1;
};

struct Estimates {
  std::vector<EstimatePair> moments;  ///< in the order of kMoments
  BinEstimates y, v;
  /// Half-width of a 95 % interval in standard errors (Student's t).
  double interval_factor = 0;
};

/// Mean of L A_i B_j in each stream, impacts included, shape (functions, streams); the function is
/// in row i * v.size() + j.
Eigen::MatrixXd generator_means(const ControlSetup& setup,
                                std::span<const mcs::StreamDeposit> streams);

/// Estimates E[f] = mean of (f + L h) for every functional. The estimate is unbiased for any h. The
/// standard errors come from the differences between streams.
Estimates estimate_functionals(const ControlSetup& setup, const Eigen::MatrixXd& generator,
                               std::span<const mcs::StreamDeposit> streams);

}  // namespace fpkcheck::control_variates
