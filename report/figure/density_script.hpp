#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/figure/content.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// A gnuplot script that draws the marginal densities of a case in the panels of the paper's Figs.
/// 2-5: (a) p(y), (b) the logarithm of p(y), (c) p(y'), (d) the logarithm of p(y'). Panels (e) and
/// (f) show the differences from the reference, since the curves nearly coincide. A figure for a
/// single journal column has only the panels of the logarithms and of the differences, one above
/// the other. The script contains the data. output_commands describes the output of the script.
/// @param content curves of at least one marginal density
std::string density_script(const problem::Problem& problem, const FigureContent& content,
                           const std::string& file_stem, FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
