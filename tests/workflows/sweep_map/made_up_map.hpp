#pragma once

#include <string>
#include <vector>

#include "workflows/sweep/map/validity_map.hpp"

/// Maps with invented results.
namespace fpkcheck::tests {

/// Ten impulses per decay time, damping ratio 0.05, linear, r = 0.9, gaussian.
inline sweep::ValidityMapCoordinates made_up_place(double impulses = 10, double restitution = 0.9) {
  return {.groups = {.impulses_per_decay_time = impulses, .damping_ratio = 0.05, .cubic_share = 0},
          .restitution = restitution,
          .law = "gaussian",
          .relative_mean = 0};
}

inline sweep::ValidityMapResult answer(double l1, double seconds,
                                       transform::Status status = transform::Status::ok) {
  return {.status = status, .l1 = l1, .underestimated = false, .seconds = seconds};
}

/// A fast closure, a slow closure and the reference at five points around made_up_place(), 0.1
/// apart in the logarithm of the impulses per decay time.
inline sweep::ValidityMap made_up_map() {
  sweep::ValidityMap map{.methods = {"epc-moment-n4", "epc-polar-n6", "fd-kf"}, .points = {}};
  for (const double impulses :
       {8.187307530779819, 9.048374180359595, 10.0, 11.051709180756477, 12.214027581601698}) {
    map.points.push_back(
        {made_up_place(impulses), {answer(0.004, 0.03), answer(0.0004, 0.3), answer(0.0001, 1)}});
  }
  return map;
}

}  // namespace fpkcheck::tests
