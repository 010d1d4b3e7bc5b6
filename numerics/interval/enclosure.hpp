#pragma once

#include <algorithm>

namespace fpkcheck::numerics {

/// An enclosure lower <= x <= upper of a number x. Code that is compiled without the options of
/// interval arithmetic (interval.hpp) uses this type for results of interval arithmetic.
struct Enclosure {
  double lower = 0, upper = 0;

  double middle() const { return lower + (upper - lower) / 2; }
  double half_width() const { return (upper - lower) / 2; }
  bool contains(double x) const { return lower <= x && x <= upper; }
  /// The intersection of two enclosures of the same number.
  Enclosure intersection(const Enclosure& other) const {
    return {std::max(lower, other.lower), std::min(upper, other.upper)};
  }
};

}  // namespace fpkcheck::numerics
