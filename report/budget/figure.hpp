#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the error budget of a case on logarithmic axes: for each marginal density a
/// panel of the L1 distances and a panel of the tail distances. Each closure has a group of bars,
/// with a bar for each part of the error budget and a black line at the total distance. The page
/// shows only the L1 distances; a figure for a single journal column omits the panels of the tail
/// distances. The figure has no panels if the case has no error budget.
Figure budget_figure(const results::CaseResult& case_result,
                     FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
