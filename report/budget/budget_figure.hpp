#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the error budget of a case, with logarithmic axes. Each marginal density has
/// a panel of L1 distances and a panel of tail distances. Each closure has a group of bars, with a
/// bar for each part of the error budget and a black line at the total distance. The report page
/// and a figure for a single journal column omit the panels of tail distances. The figure has no
/// panels if the case has no error budget.
Figure budget_figure(const results::CaseResult& case_result,
                     FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
