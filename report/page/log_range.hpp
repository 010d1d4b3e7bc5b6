#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fpkcheck::report {

/// The range of a logarithmic axis that contains all values passed to include(), with a margin at
/// both ends. Values without a finite logarithm are ignored.
class LogAxisRange {
 public:
  void include(double value) {
    if (!(value > 0) || !std::isfinite(value)) return;
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }

  /// The ends of the axis as exponents of ten; the margins are in decades.
  std::array<double, 2> exponents(double margin_below, double margin_above) const {
    if (most_ < least_) return {-1, 1};
    return {std::log10(least_) - margin_below, std::log10(most_) + margin_above};
  }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

}  // namespace fpkcheck::report
