#pragma once

#include "epc/contact/coordinates.hpp"
#include "epc/half_plane/root_search.hpp"
#include "epc/summary.hpp"
#include "transform/joint_density.hpp"

namespace fpkcheck::epc::contact {

/// Returns averages of the closure density over cells that become narrower towards the corner y = v
/// = 0. Cells of equal width would not resolve the singularities p(y) ~ y^(-1/2) and p(y') ~
/// -ln|y'| of the marginal densities.
transform::GridDensity average_on_graded_cells(const transform::SmoothDensity& density);

/// Stores in a result the averages of the density over graded cells, the atom at rest, the total
/// probability, the moments, and the residuals of the balances of power, virial and momentum.
void store_density_and_atom(const problem::Problem& problem,
                            const AmplitudeVelocityCoordinates& coordinates,
                            const half_plane::ClosureRootSearchResult& root,
                            const transform::SmoothDensity& density, ClosureResult& result);

}  // namespace fpkcheck::epc::contact
