#pragma once

#include <span>
#include <vector>

#include "mcs/estimate/estimate.hpp"

namespace fpkcheck::mcs {

/// Weights of the streams' averages: the control-variate estimate (Lavenberg & Welch, Management
/// Science 27, 1981) written as a weighted mean.
///
/// A stream whose impulses happened to do more work than expected has larger y and y' than the
/// stationary average. The expectation of that work is known from the impulse law alone, whatever
/// the oscillator does with it. Let x_s be what stream s found and b_s its excess power (mean
/// zero), and let the streams fall into two halves, with means x_A, b_A, x_B, b_B and least-squares
/// slopes beta_A, beta_B of x on b. Each half is corrected by the slope of the other, which is
/// independent of it, so that no bias arises:
///
///     estimate = (n_A/n) (x_A - beta_B b_A) + (n_B/n) (x_B - beta_A b_B) = sum w_s x_s,
///     w_s = 1/n - (n_B/n) b_B (b_s - b_A) / S_A   for s in A,   S_A = sum_A (b_s - b_A)^2,
///
/// and the other way round in B; sum w_s = 1, sum w_s b_s = 0. One set of weights serves moments,
/// histogram and fluxes alike, so these stay consistent with one another. They are near 1/n; only
/// in short runs with few streams may one be negative.
class StreamWeights {
 public:
  /// @param excess_powers one per stream, eight or more
  explicit StreamWeights(std::span<const double> excess_powers);

  double operator[](std::size_t stream) const { return weights_[stream]; }
  std::size_t size() const { return weights_.size(); }

  /// The weighted mean of one number per stream, with the standard error from the residuals of the
  /// regression.
  Estimate estimate(std::span<const double> values) const;

  /// What each stream adds to the error of that mean: numbers whose squares sum to the square of
  /// the standard error, and whose products with those of other values sum to the covariance.
  std::vector<double> errors(std::span<const double> values) const;

  /// The half-width of a 95 % interval, in standard errors (Student's t).
  double interval_factor() const;

 private:
  int degrees_of_freedom() const;

  std::vector<double> weights_;
  std::vector<double> controls_;  // b_s less the mean of all
  double control_square_ = 0;     // the sum of their squares
};

/// The plain mean of one number per stream and its standard error.
Estimate plain_estimate(std::span<const double> values);

}  // namespace fpkcheck::mcs
