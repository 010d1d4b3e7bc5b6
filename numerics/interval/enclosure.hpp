#pragma once

#include <algorithm>

namespace fpkcheck::numerics {

/// An enclosure lower <= x <= upper of a number x, computed by interval arithmetic. The header
/// enclosure.hpp requires no special compiler options, in contrast to the header interval.hpp.
struct Enclosure {
  double lower = 0, upper = 0;

  double midpoint() const { return lower + (upper - lower) / 2; }
  double half_width() const { return (upper - lower) / 2; }
  bool contains(double x) const { return lower <= x && x <= upper; }
  Enclosure intersection(const Enclosure& other) const {
    return {std::max(lower, other.lower), std::min(upper, other.upper)};
  }
};

}  // namespace fpkcheck::numerics
