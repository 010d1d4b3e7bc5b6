#pragma once

#include "epc/half_plane/closure_formulation.hpp"
#include "epc/half_plane/root.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::half_plane {

/// Energy beyond which a density with this confinement level is 0.
double support_of(double level, Tail tail);

/// Confinement of a tail; none for Tail::cut.
Confinement confinement_of(double level, Tail tail);

/// Solves the even orders in turn, each from the density of order n - 2 and on a domain adapted to
/// it. If that fails, formulations with can_start_at_any_order restart from the first density.
/// Each order uses the first confinement level at which the density has decayed, else the level
/// with the smallest decay ratio. The requested order is refined until the quadrature resolves the
/// root.
Root find_root(const ClosureFormulation& formulation, const Options& options);

}  // namespace fpkcheck::epc::half_plane
