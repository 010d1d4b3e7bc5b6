#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "results/run.hpp"

namespace fpkcheck::report {

/// Largest number of curves in the default selection: readers cannot distinguish more than six
/// nearly coincident curves.
inline constexpr std::size_t kMaxDefaultCurves = 6;

/// Returns the ids of the solutions whose curves the picture of a case shows.
///
/// The default selection of curves contains all external densities. Further solutions are added, up
/// to kMaxDefaultCurves curves, in this order: the reference, the remaining solutions of the full
/// problem (report/case_solutions.hpp), the closest closure of each formulation, solutions of
/// approximate equations by decreasing trust, remaining closures (`ok` and closest first).
/// @param requested ids, families or solvers whose curves are shown, or "all". If `requested` is
///        empty, the default selection of curves is shown.
std::set<std::string> select_solutions_to_draw(const results::CaseResult& case_result,
                                               const std::vector<std::string>& requested = {});

/// Returns the ids of the solutions whose curves are initially visible on the report page: the
/// solutions of the full problem (report/case_solutions.hpp), the closest closure of each family,
/// and external densities. If fewer than two solutions of the case would be visible, all solutions
/// of the case are visible.
std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result);

/// Checks that every requested id, family or solver matches a solution.
/// @param requested requested ids, families or solvers, the argument of select_solutions_to_draw()
/// @param available  identities of the available solutions
/// @throws InputError with a message of one line if a requested name matches no solution
void require_requested_curves_exist(const std::vector<std::string>& requested,
                                    std::span<const transform::SolutionIdentity> available);

}  // namespace fpkcheck::report
