#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace fpkcheck::numerics {

/// The 0.975 quantile of the standard normal law, rounded to seven digits: half-width of a 95 %
/// confidence interval in standard errors.
inline constexpr double kNormal95 = 1.959964;

/// Returns the density of the standard normal law.
inline double normal_density(double x) {
  return std::exp(-x * x / 2) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}

/// Returns the probability that a standard normal variable is at most x.
inline double normal_probability(double x) { return std::erfc(-x / std::numbers::sqrt2) / 2; }

/// Returns the median of a sample; for an even number of values the larger of both middle values.
/// @pre the sample is not empty
inline double median(std::vector<double> sample) {
  assert(!sample.empty());
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::ranges::nth_element(sample, middle);
  return *middle;
}

}  // namespace fpkcheck::numerics
