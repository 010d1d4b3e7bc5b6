#pragma once

#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::paper {

/// Returns the paper's Figs. 2-5, one figure for each case, with the curves EPC (n = 2), (n = 4),
/// (n = 6) and MCS. The panels are (a) p(y), (b) the logarithm of p(y), (c) p(y'), (d) the
/// logarithm of p(y'). If the status of a closure is not `ok`, the legend states the status. A case
/// without any of these four densities has no figure.
std::vector<report::PictureScript> paper_figure_scripts(
    const results::Run& run, report::FigureWidth width = report::FigureWidth::screen);

/// Returns two plots for each figure of the paper. The first plot has the panels a and b, the
/// second plot the panels c and d.
std::vector<std::vector<report::PagePlot>> paper_figure_plots(const results::Run& run);

}  // namespace fpkcheck::paper
