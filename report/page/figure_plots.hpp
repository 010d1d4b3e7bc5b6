#pragma once

#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "report/page/plot.hpp"

namespace fpkcheck::report {

/// Writes a figure for the page: a plot for each panel.
/// @param prefix prefix of the ids of the plots
std::vector<Plot> figure_plots(const Figure& figure, const std::string& prefix);

}  // namespace fpkcheck::report
