#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/figure/content.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// A gnuplot script that draws a case with the panels of the paper's Figs. 2-5: (a) p(y), (b) its
/// logarithm, (c) p(y'), (d) its logarithm. Panels (e) and (f) show the differences from the
/// reference, since the curves nearly coincide. A single journal column has only the logarithms and
/// the differences, one above the other. The script includes the data; its output is that of
/// output_commands.
/// @param content with at least one marginal
std::string density_script(const problem::Problem& problem, const FigureContent& content,
                           const std::string& file_stem, FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
