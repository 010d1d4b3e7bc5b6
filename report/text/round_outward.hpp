#pragma once

#include <string>

namespace fpkcheck::report {

/// The decimal texts of the ends of an interval.
struct IntervalText {
  std::string lower, upper;
};
/// Rounds the ends of an interval outwards to decimals. The number of decimals resolves two digits
/// of the width, so that the texts of the ends differ.
IntervalText round_outward(double lower, double upper);

}  // namespace fpkcheck::report
