#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "epc/polar/coordinates.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::polar {

/// Density C exp(Q_n + confinement), where Q_n is a polynomial of amplitude and phase. The density
/// is 0 beyond an energy.
/// @param support energy beyond which the density is 0
transform::SmoothDensity density_from_exponent(const Polynomial& q, const Coordinates& coordinates,
                                               double support,
                                               const half_plane::Confinement& confinement,
                                               double log_constant);

}  // namespace fpkcheck::epc::polar
