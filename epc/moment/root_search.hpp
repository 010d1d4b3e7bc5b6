#pragma once

#include <memory>

#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Returns the closure formulation in the coordinates y and v.
/// @param problem must outlive the formulation
std::unique_ptr<half_plane::ClosureFormulation> make_formulation(const problem::Problem& problem,
                                                                 const ClosureOptions& options);

/// Searches for the root by half_plane::find_closure_root() in the coordinates y and v. The
/// confinement level is the energy at which exp(Q_n) is negligible, or else an energy at which the
/// density has decayed. starts_from_equivalent_linearisation() selects the start.
half_plane::ClosureRootSearchResult find_closure_root(const problem::Problem& problem,
                                                      const ClosureOptions& options);

}  // namespace fpkcheck::epc::moment
