#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"
#include "transform/density.hpp"

namespace fpkcheck::epc::contact {

/// Averages of the density over cells that are graded towards the corner. Panels and bins of equal
/// width would not resolve the probability near the corner and the singularities p(y) ~ y^(-1/2)
/// and p(y') ~ -ln|y'|.
transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density);

/// Stores a density and its atom in a result: the averages of the density over graded cells, and
/// the total probability of cells and atom. The moments and the residuals of the balances of power,
/// virial and momentum are computed with the quadrature points of the root.
/// @param density density of the root
void store_density_and_atom(const problem::Problem& problem, const Coordinates& coordinates,
                            const half_plane::RootSearchResult& root,
                            const transform::SmoothDensity& density, Result& result);

}  // namespace fpkcheck::epc::contact
