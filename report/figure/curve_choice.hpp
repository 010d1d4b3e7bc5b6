#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// More curves than these are not told apart where they nearly coincide.
inline constexpr std::size_t kMostCurves = 6;

/// Ids of the solutions that a case's picture shows.
///
/// With nothing wanted these: what came from files, always; and with them, up to kMostCurves in
/// all, the reference, the other solutions of the problem itself (report/references.hpp), the
/// closest closure of each formulation, then other equations by decreasing trust, then other
/// closures, those that are ok and closest first.
/// @param wanted ids, families or solvers, all of whose curves are shown; or "all"
std::set<std::string> chosen_curves(const results::Case& one,
                                    const std::vector<std::string>& wanted = {});

/// @param wanted as of chosen_curves
/// @param there  whose curves there are to choose from
/// @throws InputError on one line for an item that means none of them
void require_curves(const std::vector<std::string>& wanted,
                    std::span<const transform::Identity> there);

}  // namespace fpkcheck::report
