#include "mcs/stream_weights.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

namespace fpkcheck::mcs {
namespace {

double mean(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

StreamWeights::StreamWeights(std::span<const double> excess_powers)
    : weights_(excess_powers.size(), 1 / static_cast<double>(excess_powers.size())) {
  const double b_bar = mean(excess_powers);
  for (const double b : excess_powers) {
    controls_.push_back(b - b_bar);
    control_square_ += controls_.back() * controls_.back();
  }
  const auto weight = [&](double control) {
    return 1 / static_cast<double>(size()) - b_bar * control / control_square_;
  };
  const bool positive = control_square_ > 0 && std::ranges::all_of(controls_, [&](double control) {
                          return weight(control) > 0;
                        });
  if (positive) {
    std::ranges::transform(controls_, weights_.begin(), weight);
  } else {
    std::ranges::fill(controls_, 0.0);
    control_square_ = 0;
  }
}

int StreamWeights::degrees_of_freedom() const {
  return static_cast<int>(size()) - (control_square_ > 0 ? 2 : 1);
}

Estimate StreamWeights::estimate(std::span<const double> values) const {
  const double x_bar = mean(values);
  double weighted = 0, product = 0, weight_square = 0;
  for (std::size_t s = 0; s < size(); ++s) {
    // As a correction to the plain mean: no loss of digits where all values are nearly the same.
    weighted += weights_[s] * (values[s] - x_bar);
    product += controls_[s] * values[s];
    weight_square += weights_[s] * weights_[s];
  }
  const double slope = control_square_ > 0 ? product / control_square_ : 0;
  double residual_square = 0;
  for (std::size_t s = 0; s < size(); ++s) {
    const double residual = values[s] - x_bar - slope * controls_[s];
    residual_square += residual * residual;
  }
  return {x_bar + weighted, std::sqrt(residual_square / degrees_of_freedom() * weight_square)};
}

double StreamWeights::interval_factor() const {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom()), 0.975);
}

Estimate plain_estimate(std::span<const double> values) {
  const double x_bar = mean(values);
  double square = 0;
  for (const double x : values) square += (x - x_bar) * (x - x_bar);
  const auto n = static_cast<double>(values.size());
  return {x_bar, std::sqrt(square / (n - 1) / n)};
}

}  // namespace fpkcheck::mcs
