#pragma once

#include "epc/half_plane/root.hpp"
#include "epc/half_plane/setting.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::half_plane {

/// The energy up to which a density with this level is used.
double support_of(double level, Tail tail);

/// The confinement that a tail has.
Confinement confinement_of(double level, Tail tail);

/// Follows the solution up the even orders, n - 2 to n, each on a domain from the density before,
/// or from the first where that leads nowhere.
/// At each order it takes the first level at which the density has decayed, else the one at which
/// it has decayed most; at the last, on as many points as it takes.
Root find_root(const Setting& setting, const Options& options);

}  // namespace fpkcheck::epc::half_plane
