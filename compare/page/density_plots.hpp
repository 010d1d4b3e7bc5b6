#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "compare/marginals_csv.hpp"
#include "compare/page/plot.hpp"

namespace fpkcheck::compare {

/// p(y) and p(y'): for each variable one plot with the density linear and logarithmic and its
/// difference from the reference; the simulation as points in its 95 % band.
/// @param summary_case one element of "cases" in summary.json
/// @param curves the curves of this case
/// @param prefix how the ids of the plots begin
std::vector<Plot> density_plots(const nlohmann::ordered_json& summary_case,
                                std::span<const MarginalCurve> curves, const std::string& prefix);

}  // namespace fpkcheck::compare
