#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/summary.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// Stores a density with its atom in a result: averages over graded cells and the mass of cells and
/// atom. Moments and the residuals of the balances of power, virial and momentum use the quadrature
/// of the root.
/// @param density density of the root
void fill_density_and_atom(const problem::Problem& problem, const Coordinates& coordinates,
                           const half_plane::Root& root, const transform::SmoothDensity& density,
                           Result& result);

}  // namespace fpkcheck::epc::contact
