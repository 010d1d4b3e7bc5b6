#include "mcs/estimate/stream_weights.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace fpkcheck::mcs {
namespace {

double mean_of_values(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double sum_of_squares_about(double centre, std::span<const double> values) {
  double sum = 0;
  for (const double x : values) sum += (x - centre) * (x - centre);
  return sum;
}

// Returns whether the control variate, the excess power, is equal in all streams up to rounding.
bool is_negligible(double square_about_mean, std::span<const double> values) {
  constexpr double kRounding = 1e-12;
  return square_about_mean <= sum_of_squares_about(0, values) * kRounding * kRounding;
}

}  // namespace

TrajectoryStreamWeights::TrajectoryStreamWeights(std::span<const double> excess_powers)
    : weights_(excess_powers.size(), 1 / static_cast<double>(excess_powers.size())) {
  const auto n = static_cast<double>(excess_powers.size());
  const auto first = excess_powers.first(excess_powers.size() / 2);
  const auto second = excess_powers.subspan(first.size());
  const auto correct = [&](std::span<const double> half, std::span<const double> other,
                           std::span<double> weights) {
    const double half_mean = mean_of_values(half), square = sum_of_squares_about(half_mean, half);
    if (is_negligible(square, half)) return;
    const double scale = static_cast<double>(other.size()) / n * mean_of_values(other) / square;
    for (std::size_t s = 0; s < half.size(); ++s) weights[s] -= scale * (half[s] - half_mean);
  };
  const std::span<double> weights = weights_;
  correct(first, second, weights.first(first.size()));
  correct(second, first, weights.subspan(first.size()));

  const double b_bar = mean_of_values(excess_powers);
  for (const double b : excess_powers) controls_.push_back(b - b_bar);
  control_square_ = sum_of_squares_about(b_bar, excess_powers);
  if (is_negligible(control_square_, excess_powers)) control_square_ = 0;
}

int TrajectoryStreamWeights::degrees_of_freedom() const {
  return static_cast<int>(size()) - 3;  // 3 estimated parameters: one mean and two slopes
}

MeanEstimate TrajectoryStreamWeights::estimate_mean(std::span<const double> values) const {
  const double x_bar = mean_of_values(values);
  double weighted = 0;
  for (std::size_t s = 0; s < size(); ++s) {
    // The stream weights multiply the deviations from the unweighted mean, which avoids
    // cancellation if all values are nearly equal.
    weighted += weights_[s] * (values[s] - x_bar);
  }
  double square = 0;
  for (const double error : stream_error_contributions(values)) square += error * error;
  return {x_bar + weighted, std::sqrt(square)};
}

std::vector<double> TrajectoryStreamWeights::stream_error_contributions(
    std::span<const double> values) const {
  const double x_bar = mean_of_values(values);
  double product = 0, weight_square = 0;
  for (std::size_t s = 0; s < size(); ++s) {
    product += controls_[s] * values[s];
    weight_square += weights_[s] * weights_[s];
  }
  const double slope = control_square_ > 0 ? product / control_square_ : 0;
  const double scale = std::sqrt(weight_square / degrees_of_freedom());
  std::vector<double> result(size());
  for (std::size_t s = 0; s < size(); ++s) {
    result[s] = (values[s] - x_bar - slope * controls_[s]) * scale;
  }
  return result;
}

double TrajectoryStreamWeights::confidence_interval_factor() const {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom()), 0.975);
}

MeanEstimate estimate_unweighted_mean(std::span<const double> values) {
  const double x_bar = mean_of_values(values);
  const auto n = static_cast<double>(values.size());
  return {x_bar, std::sqrt(sum_of_squares_about(x_bar, values) / (n - 1) / n)};
}

}  // namespace fpkcheck::mcs
