#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the L1 distances between closures and the reference against the closure
/// order n. Each marginal density has a panel, and each family of closures a curve. An external
/// density is a mark at its closure order, or a horizontal line if the order is unknown. The figure
/// has no panels if no family of closures has known distances at two or more orders.
Figure convergence_figure(const results::CaseResult& case_result);

/// Makes the figure of the L1 distances from the reference against the computing time, with one
/// panel for each marginal density. The figure has no panels without a reference.
Figure computing_time_figure(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
