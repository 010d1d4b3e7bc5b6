#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mcs/deposit/deposit.hpp"
#include "mcs/estimate/estimate.hpp"
#include "mcs/streams/stream.hpp"
#include "transform/balance_residuals.hpp"
#include "transform/metric.hpp"

namespace fpkcheck::mcs {

/// The deposit of one stream and its normalisation.
struct StreamDeposit {
  Deposit sums;
  double samples = 0;                           ///< N, the divisor of the sums
  double time = 0;                              ///< T
  double impacts = 0;                           ///< number of impacts
  std::array<double, kPowers.size()> powers{};  ///< sums of y^p y'^q in the order of kPowers
};

/// Statistics of a simulation, besides the members that every solution has.
struct Summary {
  double time = 0;  ///< simulated time over all streams, without the burn-in
  std::uint64_t samples = 0;
  double sampling_interval = 0;
  /// Var(y'^2) / SE^2 with the plain standard error, that is without weights: the number of
  /// independent draws of the stationary density with the same standard error of E[y'^2].
  double effective_samples = 0;
  double effective_samples_y2 = 0;  ///< likewise for E[y^2]
  /// Variance reduction by the weights: plain variance of the estimate over its weighted variance.
  double variance_reduction_y2 = 1;
  double variance_reduction_v2 = 1;
  /// Power of the drawn impulses less its expectation, relative to lambda E[Y^2]/2, and its
  /// standard error. The weights remove this excess from the estimates. An excess of many standard
  /// errors indicates impulses that do not follow their law.
  double excess_power = 0;
  double excess_power_error = 0;
  double outside_fraction = 0;  ///< fraction of the samples beyond the histogram
  std::uint64_t seed = 0;
  int threads = 0;
  int streams = 0;
  double step = 0;                        ///< radians, Options::step
  std::optional<double> kick_interval{};  ///< white noise: time between kicks
  double burn_in = 0;                     ///< per stream
  Estimate impact_rate{};                 ///< impacts per unit time, int |v| p(0, v) dv over v < 0
  bool impacts_accumulate = false;  ///< to rest in contact: the rate is infinite and not stated
  transform::BalanceResiduals balances{};        ///< residuals of the weighted averages
  transform::BalanceResiduals balance_errors{};  ///< standard errors of the residuals
  std::uint64_t impulses = 0;
  std::uint64_t flights = 0;  ///< number of Taylor polynomials
  std::uint64_t rounds = 0;
  bool interrupted = false;  ///< by Options::stop
  /// E[y^p y'^q], p + q <= 4, in the order of kPowers.
  std::vector<Estimate> joint_moments{};
  std::vector<Quantile> y_quantiles{}, v_quantiles{};
  std::vector<LevelRate> crossings{}, peaks{};
  std::vector<double> thresholds{};  ///< threshold energies of the splitting
  /// Standard errors of the averages of the joint histogram, row-major.
  std::vector<double> joint_standard_errors{};
  /// Deposits of the streams on Options::deposit, in their order; empty without a grid.
  std::vector<StreamDeposit> deposits{};
  /// Problems without an effect on the result, one line each (Options::warn).
  std::vector<std::string> warnings{};
};

/// The metrics of a summary, for files and pages: everything except the standard errors of the
/// joint histogram, the deposits and the warnings.
transform::Metrics metrics(const Summary& summary);

}  // namespace fpkcheck::mcs
