#pragma once

#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::paper {

/// The paper's Figs. 2-5, with a figure for each case: (a) p(y), (b) the logarithm of p(y), (c)
/// p(y'), (d) the logarithm of p(y'). The curves are those of the paper: EPC (n = 2), (n = 4), (n =
/// 6) and MCS. A closure whose status is not `ok` has the status beside its name. The file stems
/// are "paper-fig-2" etc.; a case without any of these densities has no figure.
std::vector<report::PictureScript> paper_figures(
    const results::Run& run, report::FigureWidth width = report::FigureWidth::screen);

/// The paper's figures as plots of the page, with a group of two plots for each figure: panels a
/// and b in the first plot, panels c and d in the second plot.
std::vector<std::vector<report::Plot>> paper_figure_plots(const results::Run& run);

}  // namespace fpkcheck::paper
