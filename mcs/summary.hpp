#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mcs/deposit/sample_deposit.hpp"
#include "mcs/estimate/stream_weights.hpp"
#include "mcs/streams/trajectory_stream.hpp"
#include "transform/solver_metric.hpp"

namespace fpkcheck::mcs {

/// Sums over the deposited samples of one trajectory stream, with the number of samples and the
/// simulated time that normalise the sums.
struct DepositedSumsOfTrajectory {
  DepositedSampleSums sums;
  double samples = 0;  ///< number of samples N, the divisor of the sums
  double time = 0;     ///< simulated time T of the stream
  double impacts = 0;
  std::array<double, kRecordedMomentPowers.size()>
      powers{};  ///< sums of y^p y'^q in the order of kRecordedMomentPowers
};

/// Statistics of a simulation that are not members of transform::Solution.
struct SimulationSummary {
  double time = 0;  ///< simulated time over all streams, without the burn-in
  std::uint64_t samples = 0;
  double sampling_interval = 0;
  /// Effective number of samples Var(y'^2) / SE^2: the number of independent draws of y'^2 whose
  /// mean would have the standard error SE of the unweighted estimate of E[y'^2]
  double effective_samples = 0;
  double effective_samples_y2 = 0;  ///< effective number of samples for E[y^2]
  /// Variance reduction by the weights of the trajectory streams: variance of the unweighted mean
  /// divided by the variance of the weighted mean
  double variance_reduction_y2 = 1;
  double variance_reduction_v2 = 1;
  /// Excess power, i.e. the power of the drawn impulses minus the expected power, relative to
  /// lambda E[Y^2]/2, and the standard error of the excess power. The weights of the trajectory
  /// streams remove the effect of the excess power from the estimates. An excess power of many
  /// standard errors indicates that the drawn impulses do not follow the impulse law.
  double excess_power = 0;
  double excess_power_error = 0;
  double outside_fraction = 0;
  std::uint64_t seed = 0;
  int threads = 0;
  int streams = 0;
  double step = 0;  ///< limit of the Taylor step in radians, SimulationOptions::step
  std::optional<double> kick_interval{};
  double burn_in = 0;
  MeanEstimate impact_rate{};  ///< impacts per unit time, int |v| p(0, v) dv over v < 0
  /// Whether series of infinitely many impacts end with the mass at rest in contact; the impact
  /// rate is then infinite and not stated
  bool impacts_accumulate = false;
  transform::BalanceResiduals balances{};  ///< residuals of the balances of the weighted averages
  transform::BalanceResiduals balance_errors{};  ///< standard errors of the residuals in `balances`
  std::uint64_t impulses = 0;
  std::uint64_t flights = 0;  ///< number of Taylor polynomials of all flights
  std::uint64_t rounds = 0;
  bool interrupted = false;
  /// Estimated moments E[y^p y'^q], p + q <= 4, in the order of kRecordedMomentPowers
  std::vector<MeanEstimate> joint_moments{};
  std::vector<QuantileWithConfidenceInterval> y_quantiles{}, v_quantiles{};
  std::vector<RateOfEventsAtLevel> crossings{}, peaks{};
  std::vector<double> thresholds{};
  /// Standard errors of the cell averages of the density in the joint histogram, row-major
  std::vector<double> joint_standard_errors{};
  /// Sums of each trajectory stream on the grid SimulationOptions::deposit; empty without a grid
  std::vector<DepositedSumsOfTrajectory> deposits{};
  /// One-line warnings about difficulties of the simulation that do not affect the result
  /// (SimulationOptions::warn)
  std::vector<std::string> warnings{};
};

/// Returns the metrics of a simulation summary for files and pages: all members except the standard
/// errors of the joint histogram, the deposited sums and the warnings.
transform::Metrics solver_metrics(const SimulationSummary& summary);

}  // namespace fpkcheck::mcs
