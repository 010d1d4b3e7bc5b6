#pragma once

#include "epc/half_plane/closure_formulation.hpp"
#include "epc/half_plane/root_search_result.hpp"
#include "epc/options.hpp"

namespace fpkcheck::epc::half_plane {

/// Energy beyond which a density with a given confinement level is 0.
double support_energy(double level, TailTreatment tail);

/// Confinement with a given level; no confinement for TailTreatment::cut.
Confinement confinement_of(double level, TailTreatment tail);

/// Searches for the root of the requested order. The search solves the even orders in turn. Each
/// order starts from the density of order n - 2, on a domain adapted to that density. If an order
/// has no root from this start, formulations with can_start_at_any_order() restart from the first
/// density. Each order uses the first confinement level at which the density has decayed, else the
/// level with the smallest decay ratio. At the requested order, the number of quadrature points is
/// increased until the quadrature resolves the root.
RootSearchResult find_root(const ClosureFormulation& formulation, const Options& options);

}  // namespace fpkcheck::epc::half_plane
