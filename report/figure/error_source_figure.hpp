#pragma once

#include "report/figure/figure.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Makes the figure of the error sources of a case. Each solution has two heat maps over the phase
/// plane: the contributions to the errors of E[y^2] and of E[y'^2]. Each map has its own colour
/// scale, on which the colour depends on the signed square root of the value. The figure shows the
/// closest closure of each formulation and the solutions of the full problem, at most four
/// solutions, or two in a single journal column. The figure has no panels if all error sources are
/// 0 or missing, or if their cells differ.
Figure error_source_figure(const results::CaseResult& case_result,
                           FigureWidth width = FigureWidth::screen);

/// Makes the figure of the error sources of all solutions, one of which the reader of the page
/// selects. Closures come first, by increasing distance from the reference.
Figure error_source_page_figure(const results::CaseResult& case_result);

}  // namespace fpkcheck::report
