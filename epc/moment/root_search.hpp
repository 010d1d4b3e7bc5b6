#pragma once

#include <memory>

#include "epc/half_plane/root_search.hpp"
#include "epc/options.hpp"

namespace fpkcheck::problem {
struct Problem;
}  // namespace fpkcheck::problem

namespace fpkcheck::epc::moment {

/// Returns the closure formulation whose exponent is a polynomial of y and v.
/// @param problem must outlive the formulation
std::unique_ptr<half_plane::ClosureFormulation> make_formulation(const problem::Problem& problem,
                                                                 const ClosureOptions& options);

/// Searches for the root of the closure equations in y and v by half_plane::find_closure_root().
/// The confinement level is the energy at which exp(Q_n) is negligible, or else an energy at which
/// the density has decayed. The initial density is selected by
/// starts_from_equivalent_linearisation().
half_plane::ClosureRootSearchResult find_closure_root(const problem::Problem& problem,
                                                      const ClosureOptions& options);

}  // namespace fpkcheck::epc::moment
