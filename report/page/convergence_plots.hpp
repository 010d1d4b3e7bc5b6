#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// L1 to the reference over the order of the closures, a curve for each family; for each variable a
/// plot. What somebody brought along stands at its order, or as a level where it has none. None
/// where no two closures of a family can be compared.
std::vector<Plot> order_plots(const results::Case& one, const std::string& prefix);

/// L1 to the reference against the seconds that a solution took. None without a reference.
std::vector<Plot> cost_plots(const results::Case& one, const std::string& prefix);

}  // namespace fpkcheck::report
