#pragma once

#include <functional>

#include "transform/density.hpp"

namespace fpkcheck::transform {

/// A density of (z, z') = (x1, x2) on the whole plane, zero outside |x1| <= x1_max, |x2| <= x2_max.
struct PlaneDensity {
  std::function<double(double x1, double x2)> value;
  double x1_max;
  double x2_max;
};

/// The density of (y, y') = (|z|, z' sgn z), paper (5):
///
///     p(y, v) = p(z = y, z' = v) + p(z = -y, z' = -v),   y > 0.
///
/// Its marginals are paper (30) and (34). p(z, z') needs no symmetry.
SmoothDensity physical_density(PlaneDensity density);

}  // namespace fpkcheck::transform
