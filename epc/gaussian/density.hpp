#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/gaussian/support.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::gaussian {

/// ln C of paper (17), which normalises C exp(Q_n) on its support in the plane.
double log_constant(const Support& support);

/// Density of (y, y') by paper (5) from C exp(Q_n) on its support.
transform::SmoothDensity density_of(const Polynomial& q, const Support& support,
                                    double log_constant);

/// Density C exp(Q_n) of (y, v) on its support, without a wall and without folding.
transform::SmoothDensity unfolded_density_of(const Polynomial& q, const Support& support,
                                             double log_constant);

}  // namespace fpkcheck::epc::gaussian
