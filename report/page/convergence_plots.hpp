#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// For each marginal density a plot of the L1 distance to the reference against the order of the
/// closures, with a curve for each family. An external density is shown as a mark at its order, or
/// as a horizontal line if the density has no order. The list of plots is empty unless a family of
/// closures has two orders with known distances.
/// @param prefix prefix of the ids of the plots
std::vector<Plot> order_plots(const results::CaseResult& case_result, const std::string& prefix);

/// For each marginal density a plot of the L1 distance to the reference against the computing time.
/// The list of plots is empty if the case has no reference.
std::vector<Plot> cost_plots(const results::CaseResult& case_result, const std::string& prefix);

}  // namespace fpkcheck::report
