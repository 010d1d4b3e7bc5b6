#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Maximum number of curves by default: more curves that nearly coincide are indistinguishable.
inline constexpr std::size_t kMaxCurves = 6;

/// Ids of the solutions shown in the picture of a case.
///
/// The default selection has all external densities. Up to kMaxCurves curves in all follow by
/// priority: the reference, the other solutions of the full problem (report/references.hpp), the
/// closest closure of each formulation, other equations by decreasing trust, other closures (ok and
/// closest first).
/// @param requested ids, families or solvers, all of whose curves are shown; or "all"; empty for the
///               default selection
std::set<std::string> select_curves(const results::Case& case_result,
                                    const std::vector<std::string>& requested = {});

/// Checks that every requested item matches a solution.
/// @param requested as in select_curves
/// @param available  identities of the available solutions
/// @throws InputError with a message of a single line for an item that matches no solution
void validate_curves(const std::vector<std::string>& requested,
                     std::span<const transform::Identity> available);

}  // namespace fpkcheck::report
