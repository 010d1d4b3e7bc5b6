#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "control_variates/control_variate_setup.hpp"
#include "mcs/estimate/density_estimate.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/summary.hpp"

namespace fpkcheck::control_variates {

/// Two estimates of an expectation: with control variates (`controlled`) and without (`plain`).
struct EstimatesWithAndWithoutControlVariates {
  mcs::MeanEstimate controlled, plain;
};

/// Estimates of the averages of a marginal density over smooth bins.
struct SmoothBinAverageEstimates {
  transform::SmoothBins bins;
  std::vector<EstimatesWithAndWithoutControlVariates> averages;
  Eigen::MatrixXd covariance;  ///< covariance matrix of the averages with control variates
  mcs::L1SamplingError controlled_l1, plain_l1;
};

struct StationaryFunctionalEstimates {
  std::vector<EstimatesWithAndWithoutControlVariates> moments;
  SmoothBinAverageEstimates y, v;
  /// Half-width of a 95 % confidence interval in standard errors, from Student's t distribution.
  double confidence_interval_factor = 0;
};

/// Returns the mean of L A_i B_j in each stream of the simulation, including the contribution of
/// impacts, where L is the generator and A_i(y) B_j(v) is a product of splines. The matrix has the
/// shape (functions, streams), with the spline product A_i B_j in row i * v.size() + j.
Eigen::MatrixXd stream_means_of_generated_splines(
    const ControlVariateSetup& setup, std::span<const mcs::DepositedSumsOfTrajectory> streams);

/// Estimates each expectation E[f] by the sample mean of f + L h with the generator L and the
/// control variate L h. The estimate of E[f] by the mean of f + L h is unbiased for every function
/// h. The standard errors are computed from the differences between the streams of the simulation.
StationaryFunctionalEstimates estimate_functionals(
    const ControlVariateSetup& setup, const Eigen::MatrixXd& generator,
    std::span<const mcs::DepositedSumsOfTrajectory> streams);

}  // namespace fpkcheck::control_variates
