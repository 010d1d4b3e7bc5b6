#pragma once

#include <vector>

#include "report/figure/options.hpp"
#include "report/supplement.hpp"
#include "results/run.hpp"

namespace fpkcheck::paper {

/// The paper's Figs. 2-5, one for each case: (a) p(y), (b) its logarithm, (c) p(y'), (d) its
/// logarithm, of EPC (n = 2), (n = 4), (n = 6) and MCS, under these names. A closure whose status
/// is not `ok` has the status beside its name. The stems are "paper-fig-2" etc.; a case without any
/// of these densities has no figure.
std::vector<report::Picture> figures(const results::Run& run,
                                     report::FigureWidth width = report::FigureWidth::screen);

/// The same figures as plots of the page, a group for each figure: panels a and b in the first
/// plot, c and d in the second.
std::vector<std::vector<report::Plot>> figure_plots(const results::Run& run);

}  // namespace fpkcheck::paper
