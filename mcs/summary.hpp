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
#include "transform/observation.hpp"

namespace fpkcheck::mcs {

/// The deposit of one stream, with what belongs to it.
struct StreamDeposit {
  Deposit sums;
  double samples = 0;                           ///< N, what the sums are to be divided by
  double time = 0;                              ///< T
  double impacts = 0;                           ///< how many
  std::array<double, kPowers.size()> powers{};  ///< sums of y^p y'^q in the order of kPowers
};

/// What was done and what it told, beyond what every solution has.
struct Summary {
  double time = 0;  ///< simulated, over all streams, without the burn-in
  std::uint64_t samples = 0;
  double sampling_interval = 0;
  /// Var(y'^2) / SE^2 with the plain standard error, that without weights: how many independent
  /// draws of the stationary density tell as much of E[y'^2].
  double effective_samples = 0;
  double effective_samples_y2 = 0;  ///< the same of E[y^2]
  /// What the weights gain: plain variance of the estimate over the variance reached.
  double variance_reduction_y2 = 1;
  double variance_reduction_v2 = 1;
  /// Power that the impulses happened to bring beyond its expectation, relative to lambda E[Y^2]/2,
  /// and its standard error. The weights take it out of the results; being far from 0 in standard
  /// errors it would tell of impulses that do not follow their law.
  double excess_power = 0;
  double excess_power_error = 0;
  double outside = 0;  ///< fraction of the samples beyond the histogram
  std::uint64_t seed = 0;
  int threads = 0;
  int streams = 0;
  double step = 0;                         ///< radians, Options::step
  std::optional<double> kick_interval{};   ///< white noise: time between kicks
  double burn_in = 0;                      ///< of each stream
  Estimate impact_rate{};                  ///< impacts per unit time, int |v| p(0, v) dv over v < 0
  bool impacts_accumulate = false;         ///< to rest: the rate has no bound, and none is stated
  transform::BalanceResiduals balances{};  ///< of the weighted averages
  transform::BalanceResiduals balance_errors{};  ///< their standard errors
  std::uint64_t impulses = 0;
  std::uint64_t flights = 0;  ///< Taylor polynomials
  std::uint64_t rounds = 0;
  bool interrupted = false;  ///< by Options::stop
  /// E[y^p y'^q], p + q <= 4, in the order of kPowers.
  std::vector<Estimate> joint_moments{};
  std::vector<Quantile> y_quantiles{}, v_quantiles{};
  std::vector<LevelRate> crossings{}, peaks{};
  std::vector<double> thresholds{};  ///< energies of the splitting
  /// Standard errors of the joint histogram's averages, row-major.
  std::vector<double> joint_standard_errors{};
  /// What the streams put on Options::deposit, in their order; empty without.
  std::vector<StreamDeposit> deposits{};
  /// What went wrong without an effect on the result, a line each (Options::warn).
  std::vector<std::string> warnings{};
};

/// All of it but the joint histogram's errors, the deposits and the warnings, as files and pages have it.
transform::Observations observations(const Summary& summary);

}  // namespace fpkcheck::mcs
