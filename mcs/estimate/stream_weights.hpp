#pragma once

#include <span>
#include <vector>

namespace fpkcheck::mcs {

struct MeanEstimate {
  double mean = 0;
  double standard_error = 0;
};

/// Estimated quantile: a variable is below `value` with the given `probability`.
struct QuantileWithConfidenceInterval {
  double probability;
  double value;
  double lower, upper;  ///< ends of the 95 % confidence interval of the quantile
};

/// Rate of upward crossings of a level of y, or of peaks above a level of y, per unit time.
struct RateOfEventsAtLevel {
  double level;
  MeanEstimate rate;
};

/// Weights of the trajectory streams, which express an estimate with a control variate (Lavenberg &
/// Welch, Management Science 27, 1981) as a weighted mean of the stream averages.
///
/// The control variate is the work of the impulses minus the expected work: in a trajectory stream
/// with excess work, displacement and speed are larger than on average. The impulse law alone
/// determines the expected work of the impulses, for any oscillator. Let x_s be the average of a
/// quantity x in stream s, and b_s the excess power of stream s, which has mean zero. The streams
/// form two halves A and B with means x_A, b_A, x_B, b_B and least-squares slopes beta_A, beta_B of
/// x on b. The regression slope beta_A of half A corrects the mean of half B, and the regression
/// slope beta_B of half B corrects the mean of half A. Since the two halves of the streams are
/// independent, the following estimate is unbiased:
///
///     estimate = (n_A/n) (x_A - beta_B b_A) + (n_B/n) (x_B - beta_A b_B) = sum w_s x_s,
///     w_s = 1/n - (n_B/n) b_B (b_s - b_A) / S_A   for s in A,   S_A = sum_A (b_s - b_A)^2,
///
/// For a stream s in half B, the halves A and B are exchanged in the formula of the weight w_s. The
/// weights w_s and excess powers b_s of the streams satisfy sum w_s = 1 and sum w_s b_s = 0. The
/// estimates of moments, histogram and fluxes all use the stream weights w_s and are therefore
/// consistent. The weights of n streams are near 1/n; a stream weight is negative only in short
/// simulations with few streams.
class TrajectoryStreamWeights {
 public:
  /// @param excess_powers excess power of each trajectory stream, for at least eight streams
  explicit TrajectoryStreamWeights(std::span<const double> excess_powers);

  double operator[](std::size_t stream) const { return weights_[stream]; }
  std::size_t size() const { return weights_.size(); }

  /// Returns the weighted mean of a quantity with one value per trajectory stream. The standard
  /// error of the mean is computed from the residuals of the regression on the excess power.
  MeanEstimate estimate_mean(std::span<const double> values) const;

  /// Returns the contribution of each trajectory stream to the sampling error of
  /// estimate_mean(values). The sum of the squared error contributions is the squared standard
  /// error. The sum of the products of the error contributions to two means is the covariance of
  /// the two means.
  std::vector<double> stream_error_contributions(std::span<const double> values) const;

  /// Returns the half-width of a 95 % confidence interval, in standard errors (Student's t).
  double confidence_interval_factor() const;

 private:
  int degrees_of_freedom() const;

  std::vector<double> weights_;
  std::vector<double> controls_;  // excess power b_s minus the mean of b over all streams
  double control_square_ = 0;     // sum of the squared elements of controls_
};

/// Returns the unweighted mean of one value per stream, and the standard error of the mean.
MeanEstimate estimate_unweighted_mean(std::span<const double> values);

}  // namespace fpkcheck::mcs
