#pragma once

#include <set>
#include <string>
#include <vector>

#include "report/figure/content.hpp"
#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// p(y) and p(y'): for each variable one plot with the density linear and logarithmic and its
/// difference from the reference; the simulation as points in its 95 % band.
/// @param prefix how the ids of the plots begin
std::vector<Plot> density_plots(const results::Case& one, const std::string& prefix);

/// The same of some of its curves.
/// @param content of the case
/// @param shown   ids of the solutions that are not switched off at first
std::vector<Plot> density_plots(const results::Case& one, const FigureContent& content,
                                const std::set<std::string>& shown, const std::string& prefix);

}  // namespace fpkcheck::report
