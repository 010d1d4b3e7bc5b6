#pragma once

#include <set>
#include <string>
#include <vector>

#include "report/figure/content.hpp"
#include "report/page/plot.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// The ids of the solutions that are initially visible in a plot: the solutions of the full problem
/// (report/references.hpp), the closest closure of each family, and external densities. If fewer
/// than two solutions would be visible, all solutions of the case are visible.
std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result);

/// A plot for each marginal density with three rows: the density on a linear axis, the density on a
/// logarithmic axis, and the difference from the reference. The simulation is shown as points
/// within a band of 95 % confidence intervals.
/// @param prefix prefix of the ids of the plots
std::vector<Plot> density_plots(const results::CaseResult& case_result, const std::string& prefix);

/// The density plots of a case for given curves.
/// @param content the curves of the case
/// @param shown   ids of the initially visible solutions
std::vector<Plot> density_plots(const results::CaseResult& case_result,
                                const FigureContent& content, const std::set<std::string>& shown,
                                const std::string& prefix);

}  // namespace fpkcheck::report
