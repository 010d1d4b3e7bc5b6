#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transform/marginal_density.hpp"
#include "transform/solution.hpp"

namespace fpkcheck::transform {

/// Local maximum of a spectral density, with the half-width of the peak at half of the maximum.
struct SpectralPeak {
  double frequency = 0;
  double density = 0;
  /// Half of the width of the spectral peak at half of the maximum; absent if the spectral density
  /// exceeds half of the maximum everywhere on one side of the peak.
  std::optional<double> half_width = {};
};

/// A mode of the autocovariance R, a decaying exponential: an eigenvalue -(decay_rate +- i
/// frequency) of the generator, and the share R_mode(0) / R(0) of the mode in the variance.
struct CovarianceMode {
  double decay_rate = 0, frequency = 0;
  double decay_rate_error = 0, frequency_error = 0;  ///< absolute errors
  double share = 0;  ///< the shares of all modes sum to 1; a share may be negative
};

/// One-sided spectral density G of the stationary process y or y' about its mean,
///
///     G(w) = (2/pi) int_0^inf R(t) cos(w t) dt,   int_0^inf G(w) dw = R(0) = Var,
///
/// with the autocovariance R and the angular frequency w >= 0.
struct SpectralDensity {
  std::string id;  ///< id of the solution, such as "fd-kf" or "mcs"
  StateVariable variable = StateVariable::y;
  Status status = Status::failed;
  std::string reason = {};  ///< reason of the status, one sentence; empty only for status ok
  double seconds = 0;
  std::vector<double> frequencies = {};
  std::vector<double> density = {};
  /// Absolute error of the spectral density at each frequency: estimated discretisation error, or
  /// standard error
  std::vector<double> error = {};
  bool has_standard_errors = false;  ///< whether the errors are standard errors of a simulation
  /// Whether the standard errors are increased by an estimate of the error that the interval
  /// between noise kicks causes
  bool has_kick_interval_errors = false;
  double variance = 0;  ///< variance of the variable, from the same solution
  double variance_error = 0;
  std::optional<SpectralPeak> peak = {};  ///< highest local maximum; absent without a maximum
  /// Autocovariance R(t) at the requested times t >= 0, and absolute errors of R(t). A simulation
  /// estimates R(t) up to a quarter of the segment length of Welch's method.
  std::vector<double> lags = {};
  std::vector<double> autocovariance = {};
  std::vector<double> autocovariance_error = {};
  /// Modes of the autocovariance with the largest shares of the variance; empty for a simulation
  std::vector<CovarianceMode> modes = {};
  std::string details = {};  ///< grid or simulated time, for tables
};

/// Returns the highest local maximum of the spectral density between the first and the last
/// frequency, from a parabola through three points; empty if the spectral density has no maximum
/// between the first and the last frequency.
std::optional<SpectralPeak> find_spectral_peak(const std::vector<double>& frequencies,
                                               const std::vector<double>& density);

}  // namespace fpkcheck::transform
