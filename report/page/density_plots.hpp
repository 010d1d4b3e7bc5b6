#pragma once

#include <string>
#include <vector>

#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// p(y) and p(y'): for each variable one plot with the density linear and logarithmic and its
/// difference from the reference; the simulation as points in its 95 % band.
/// @param prefix how the ids of the plots begin
std::vector<Plot> density_plots(const results::Case& one, const std::string& prefix);

}  // namespace fpkcheck::report
