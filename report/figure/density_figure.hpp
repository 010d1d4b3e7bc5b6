#pragma once

#include "problem/problem.hpp"
#include "report/figure/density_content.hpp"
#include "report/figure/figure.hpp"

namespace fpkcheck::report {

/// Makes the figure of the marginal densities of a case, with the panels of the paper's Figs. 2-5:
/// (a) p(y), (b) the logarithm of p(y), (c) p(y'), (d) the logarithm of p(y'). Panels (e) and (f)
/// show the differences from the reference, since the density curves nearly coincide. A figure for
/// a single journal column has only the panels of the logarithms and of the differences. On the
/// report page, the panels of one marginal density are the rows of one plot. The figure has no
/// panels if `content` has no curves.
Figure density_figure(const problem::Problem& problem, const DensityFigureContent& content,
                      FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
