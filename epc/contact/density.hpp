#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// Density C exp(Q_n + confinement) / e, Q_n a polynomial of amplitude and velocity, and 0 beyond
/// an energy; infinite at the corner.
/// @param support this energy
transform::SmoothDensity density_of(const Polynomial& q, const Coordinates& coordinates,
                                    double support, const half_plane::Confinement& confinement,
                                    double log_constant);

/// Averages of the density over cells graded towards the corner. Unlike panels and equal bins, they
/// resolve its mass and the singularities p(y) ~ y^(-1/2) and p(y') ~ -ln|y'|.
transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density);

}  // namespace fpkcheck::epc::contact
