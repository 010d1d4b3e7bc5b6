#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// C exp(Q_n + confinement) / e of amplitude and velocity up to an energy, and 0 beyond; infinite
/// at the corner.
/// @param support the energy
transform::SmoothDensity density_of(const Polynomial& q, const Coordinates& coordinates,
                                    double support, const half_plane::Confinement& confinement,
                                    double log_constant);

/// The same as averages over cells that are the narrower the nearer to the corner: what holds its
/// mass, and that of p(y) ~ y^(-1/2) and p(y') ~ -ln|y'|, as panels and even bins do not.
transform::GridDensity on_graded_cells(const transform::SmoothDensity& density);

}  // namespace fpkcheck::epc::contact
