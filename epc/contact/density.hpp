#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/form/polynomial.hpp"
#include "epc/half_plane/confinement.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// Density C exp(Q_n + confinement) / e, where Q_n is a polynomial of amplitude and velocity. The
/// density is infinite at the corner, and 0 beyond an energy.
/// @param support energy beyond which the density is 0
transform::SmoothDensity density_from_exponent(const Polynomial& q, const Coordinates& coordinates,
                                               double support,
                                               const half_plane::Confinement& confinement,
                                               double log_constant);

/// Averages of the density over cells that are graded towards the corner. Panels and bins of equal
/// width would not resolve the probability near the corner and the singularities p(y) ~ y^(-1/2)
/// and p(y') ~ -ln|y'|.
transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density);

}  // namespace fpkcheck::epc::contact
