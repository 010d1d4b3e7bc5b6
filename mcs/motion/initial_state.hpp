#pragma once

#include <cmath>

#include "mcs/impulses/impulse_source.hpp"
#include "mcs/motion/flight.hpp"

namespace fpkcheck::mcs {

/// Initial state of a stream: independent Gaussians z, z' of mean zero, folded by paper (5),
/// y = |z|, y' = z' sgn z.
inline State folded_initial_state(const ImpulseSource& source, double displacement_deviation,
                                  double velocity_deviation) {
  const auto normals = source.standard_normals();
  const double z = displacement_deviation * normals[0];
  const double z_dot = velocity_deviation * normals[1];
  return {std::abs(z), std::copysign(1.0, z) * z_dot};
}

}  // namespace fpkcheck::mcs
