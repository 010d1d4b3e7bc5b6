#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/gaussian/support.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::gaussian {

/// ln C of paper (17), by which C exp(Q_n) on its support is a density of the plane.
double log_constant(const Support& support);

/// The density of (y, y') by paper (5) from C exp(Q_n) on its support.
transform::SmoothDensity density_of(const Polynomial& q, const Support& support,
                                    double log_constant);

/// C exp(Q_n) on the support as a density of (y, v) where there is no wall: nothing is folded.
transform::SmoothDensity unfolded_density_of(const Polynomial& q, const Support& support,
                                             double log_constant);

}  // namespace fpkcheck::epc::gaussian
