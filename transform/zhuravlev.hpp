#pragma once

#include <functional>

#include "transform/density.hpp"

namespace fpkcheck::transform {

/// A joint density of (z, z') = (x1, x2) on the whole plane. The density is zero outside |x1| <=
/// x1_max, |x2| <= x2_max.
struct PlaneDensity {
  std::function<double(double x1, double x2)> value;
  double x1_max;
  double x2_max;
};

/// The density p of (y, y') = (|z|, z' sgn z), the Zhuravlev transformation of paper (5):
///
///     p(y, v) = p(z = y, z' = v) + p(z = -y, z' = -v),   y > 0.
///
/// The marginals of this density are paper (30) and (34). The density of (z, z') need not be
/// symmetric.
SmoothDensity physical_density(PlaneDensity density);

}  // namespace fpkcheck::transform
