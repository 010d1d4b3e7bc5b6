#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the L1 distances between closures and the reference against the order n: a
/// panel for each marginal density, a curve for each family. An external density is a mark at its
/// order, or a horizontal line if the density has no order. The figure has no panels if no family
/// of closures has known distances at two or more orders.
Figure convergence_figure(const results::CaseResult& case_result);

/// Makes the figure of the L1 distances to the reference against the computing time: a panel for
/// each marginal density. The figure has no panels if the case has no reference.
Figure cost_figure(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
