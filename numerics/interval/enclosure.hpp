#pragma once

#include <algorithm>

namespace fpkcheck::numerics {

/// lower <= x <= upper: what interval arithmetic leaves behind for the rest of the program.
struct Enclosure {
  double lower = 0, upper = 0;

  double middle() const { return lower + (upper - lower) / 2; }
  double half_width() const { return (upper - lower) / 2; }
  bool contains(double x) const { return lower <= x && x <= upper; }
  /// What two enclosures of the same number leave of it.
  Enclosure intersected(const Enclosure& other) const {
    return {std::max(lower, other.lower), std::min(upper, other.upper)};
  }
};

}  // namespace fpkcheck::numerics
