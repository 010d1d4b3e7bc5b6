#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// For each marginal a plot of the L1 distance to the reference over the order of the closures,
/// with a curve for each family. An external density is a mark at its order, or a horizontal line
/// without an order. Empty unless a family has two orders with known distances.
/// @param prefix of the ids of the plots
std::vector<Plot> order_plots(const results::Case& case_result, const std::string& prefix);

/// For each marginal a plot of the L1 distance to the reference against the computing time. Empty
/// without a reference.
std::vector<Plot> cost_plots(const results::Case& case_result, const std::string& prefix);

}  // namespace fpkcheck::report
