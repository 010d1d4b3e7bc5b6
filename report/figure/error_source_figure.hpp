#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the error sources of a case: for each solution two heat maps over the phase
/// plane, of the contributions to the errors of E[y^2] and E[y'^2]. Each map has its own colour
/// scale, with tics at equal steps of the value and colours by the signed square root. The
/// solutions are the closest closure of each formulation and the solutions of the full problem, at
/// most four, or two in a single journal column. The figure has no panels if all error sources are
/// 0 or missing, or if their cells differ.
Figure error_source_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Makes the figure of the error sources of all solutions, each a choice of the page: closures by
/// increasing distance to the reference, then all other solutions.
Figure error_source_page_figure(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
