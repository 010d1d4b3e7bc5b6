#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/summary.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// Puts a density with its atom into a result: averages over graded cells, mass (by those, the atom
/// with it), moments and the residuals of the balances of power, virial and momentum, all by the
/// rule that the root was found on.
/// @param density of the root
void put_density_and_atom(const problem::Problem& problem, const Coordinates& coordinates,
                          const half_plane::Root& root, const transform::SmoothDensity& density,
                          Result& result);

}  // namespace fpkcheck::epc::contact
