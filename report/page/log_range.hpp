#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fpkcheck::report {

/// The range of a logarithmic axis: what is on it, with room at both ends. What has no logarithm is
/// left out.
class LogRange {
 public:
  void include(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }

  /// The ends as powers of ten.
  std::array<double, 2> exponents(double room_below, double room_above) const {
    if (most_ < least_) return {-1, 1};
    return {std::log10(least_) - room_below, std::log10(most_) + room_above};
  }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

}  // namespace fpkcheck::report
