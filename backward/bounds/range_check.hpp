#pragma once

#include <utility>

#include "backward/bounds/check_setting.hpp"

namespace fpkcheck::backward {

struct Range {
  double least = 0, largest = 0;  ///< least <= 0 <= largest
  bool reached = true;  ///< false when bisection was given up: the range holds all the same
  long boxes = 0;       ///< that were looked at
};

/// Encloses (f + L V - U) / tau over the box of the splines: each product of a y piece and a v
/// piece by the Bernstein coefficients of the residual and the least tau on it, bisected until the
/// bounds are within `slack` of values that are taken.
/// @param expected (least, largest) values that are likely to be taken: they save work, no more
/// @pre inside rounded_upward
Range residual_range(const CheckSetting& setting, const Functional& functional,
                     const Candidate& candidate, std::pair<double, double> expected, double slack);

}  // namespace fpkcheck::backward
