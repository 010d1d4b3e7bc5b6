#pragma once

#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "epc/polar/coordinates.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::polar {

/// C exp(Q_n + confinement) of amplitude and phase up to an energy, and 0 beyond.
/// @param support the energy
transform::SmoothDensity density_of(const Polynomial& q, const Coordinates& coordinates,
                                    double support, const half_plane::Confinement& confinement,
                                    double log_constant);

}  // namespace fpkcheck::epc::polar
