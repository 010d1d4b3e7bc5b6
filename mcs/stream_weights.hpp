#pragma once

#include <span>
#include <vector>

namespace fpkcheck::mcs {

/// A mean and its standard error.
struct Estimate {
  double mean;
  double standard_error;
};

/// Weights of the streams' averages: the control-variate estimate (Lavenberg & Welch, Management
/// Science 27, 1981) written as a weighted mean.
///
/// A stream whose impulses happened to do more work than expected has larger y and y' than the
/// stationary average. The expectation of that work is known from the impulse law alone, whatever
/// the oscillator does with it. So with x_s what stream s found, b_s its excess power (mean zero),
/// the bars plain means and S = sum (b_s - b_bar)^2,
///
///     w_s = 1/n - b_bar (b_s - b_bar) / S:   sum w_s = 1,  sum w_s b_s = 0,
///     sum w_s x_s = x_bar - beta b_bar,      beta = least-squares slope of x on b.
///
/// One set of weights serves moments, histogram and fluxes alike, so these stay consistent with one
/// another; being near 1/n it keeps densities positive. Should a weight not be positive (few, short
/// streams), all become 1/n.
class StreamWeights {
 public:
  /// @param excess_powers one per stream, three or more
  explicit StreamWeights(std::span<const double> excess_powers);

  double operator[](std::size_t stream) const { return weights_[stream]; }
  std::size_t size() const { return weights_.size(); }

  /// The weighted mean of one number per stream, with the standard error from the residuals of the
  /// regression.
  Estimate estimate(std::span<const double> values) const;

  /// The half-width of a 95 % interval, in standard errors (Student's t).
  double interval_factor() const;

 private:
  int degrees_of_freedom() const;

  std::vector<double> weights_;
  std::vector<double> controls_;  // b_s - b_bar; all zero when the weights are plain
  double control_square_ = 0;     // S
};

/// The plain mean of one number per stream and its standard error.
Estimate plain_estimate(std::span<const double> values);

}  // namespace fpkcheck::mcs
