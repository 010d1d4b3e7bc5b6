#pragma once

#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Searches for the root by half_plane::find_root() in the coordinates y and v. The confinement
/// level is the energy at which exp(Q_n) is negligible. If Q_n does not fall to this depth, the
/// confinement level is an energy at which the density has decayed. Energies are defined as in
/// EnergyDomain. The start is chosen by
/// starts_from_linearisation().
half_plane::RootSearchResult find_root(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::moment
