#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/page/plot.hpp"

namespace fpkcheck::compare {

/// L1 to the reference over the order of the closures, a curve for each formulation; for each
/// variable a plot. None where no two closures can be compared.
std::vector<Plot> order_plots(const nlohmann::ordered_json& summary_case,
                              const std::string& prefix);

/// L1 to the reference against the seconds that a solution took. None without a reference.
std::vector<Plot> cost_plots(const nlohmann::ordered_json& summary_case, const std::string& prefix);

}  // namespace fpkcheck::compare
