#pragma once

#include <string>
#include <vector>

#include "report/verdict/outcome.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Returns an SVG picture of the L1 distances from the reference, with one row for each solution
/// and one mark for each case. The position of a mark on the logarithmic axis is the larger L1
/// distance of p(y) and p(y') from the reference. A line marks the distance compare::kCloseL1, and
/// a rectangle covers distances below the error estimate of the references. The picture is empty if
/// the run has no distances from a reference.
std::string distance_plot(const results::Run& run,
                          const std::vector<SolutionAgreements>& agreement_rows);

}  // namespace fpkcheck::report
