#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

namespace fpkcheck::numerics {

/// Half-width of the two-sided 95 % interval of a normal variable, in standard deviations: the
/// 0.975 quantile of the standard normal law, rounded to seven digits.
inline constexpr double kNormal95 = 1.959964;

/// Returns the median of a sample; for an even number of values, the larger of the two middle
/// values.
/// @pre the sample is not empty
inline double median(std::vector<double> sample) {
  assert(!sample.empty());
  const auto middle = sample.begin() + static_cast<std::ptrdiff_t>(sample.size() / 2);
  std::ranges::nth_element(sample, middle);
  return *middle;
}

}  // namespace fpkcheck::numerics
