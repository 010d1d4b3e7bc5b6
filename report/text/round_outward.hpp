#pragma once

#include <string>

namespace fpkcheck::report {

/// The decimal texts of the ends of an interval.
struct IntervalText {
  std::string lower, upper;
};
/// Rounds the ends of an interval outwards to decimals. The number of decimals is large enough to
/// show two significant digits of the interval width, so that the texts of both ends differ.
IntervalText round_outward(double lower, double upper);

}  // namespace fpkcheck::report
