#pragma once

#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::paper {

/// The paper's Figs. 2-5, a case each: (a) p(y), (b) its logarithm, (c) p(y'), (d) its logarithm, of
/// EPC (n = 2), (n = 4), (n = 6) and MCS, under these names; a closure that is not `ok` has its status
/// beside the name. "paper-fig-2" and so on; none of a case that has none of these densities.
std::vector<report::Picture> figures(const results::Run& run,
                                     report::FigureWidth width = report::FigureWidth::screen);

/// The same as plots of the page, a group for each figure: panels a and b in one plot, c and d in
/// the other.
std::vector<std::vector<report::Plot>> figure_plots(const results::Run& run);

}  // namespace fpkcheck::paper
