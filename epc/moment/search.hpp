#pragma once

#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// half_plane::find_root in the coordinates y and v. The confinement level is the energy at which
/// exp(Q_n) is negligible, if Q_n falls that far, else an energy at which the density has decayed.
/// Energies are those of EnergyDomain. The search starts from equivalent linearisation in the
/// paper's class, else from energy averaging.
half_plane::Root find_root(const problem::Problem& problem, const Options& options);

}  // namespace fpkcheck::epc::moment
