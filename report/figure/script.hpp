#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/figure/content.hpp"

namespace fpkcheck::report {

/// A gnuplot script that draws one case as the paper's Figs. 2-5 do: (a) p(y), (b) its logarithm,
/// (c) p(y'), (d) its logarithm; and beside them (e), (f) the differences from the reference, since
/// the curves themselves nearly coincide. It holds its data, and draws FILE_STEM.png or, with
/// format='svg', FILE_STEM.svg; the gnuplot variable `target` names another file.
/// @param content with at least one side
std::string figure_script(const problem::Problem& problem, const FigureContent& content,
                          const std::string& file_stem);

}  // namespace fpkcheck::report
