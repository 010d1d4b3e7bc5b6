#pragma once

#include "problem/problem.hpp"
#include "report/figure/content.hpp"
#include "report/figure/figure.hpp"

namespace fpkcheck::report {

/// The marginal densities of a case in the panels of the paper's Figs. 2-5: (a) p(y), (b) the
/// logarithm of p(y), (c) p(y'), (d) the logarithm of p(y'). Panels (e) and (f) show the
/// differences from the reference, since the density curves nearly coincide. A figure for a single
/// journal column has only the panels of the logarithms and of the differences. On the report page,
/// the panels of one marginal density are the rows of one plot. Without curves the figure has no
/// panels.
Figure density_figure(const problem::Problem& problem, const FigureContent& content,
                      FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
