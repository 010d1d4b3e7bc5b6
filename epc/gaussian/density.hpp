#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/gaussian/density_support.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::gaussian {

/// ln C of the constant C of paper (17), which normalises C exp(Q_n) on its support in the plane.
double log_normalising_constant(const DensitySupport& support);

/// Density of (y, y') from the density C exp(Q_n) on its support in the (z, z') plane, by paper
/// (5).
transform::SmoothDensity density_from_exponent(const Polynomial& q, const DensitySupport& support,
                                               double log_constant);

/// Density C exp(Q_n) of (y, v) on its support for a problem without a wall, whose plane is not
/// folded.
transform::SmoothDensity unfolded_density_from_exponent(const Polynomial& q,
                                                        const DensitySupport& support,
                                                        double log_constant);

}  // namespace fpkcheck::epc::gaussian
