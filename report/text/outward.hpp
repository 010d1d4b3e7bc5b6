#pragma once

#include <string>

namespace fpkcheck::report {

/// The ends of an interval in decimals, rounded outwards, with two digits of its width; so many
/// that the ends differ.
struct IntervalText {
  std::string lower, upper;
};
IntervalText outward(double lower, double upper);

}  // namespace fpkcheck::report
