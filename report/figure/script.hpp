#pragma once

#include <string>

#include "problem/problem.hpp"
#include "report/figure/content.hpp"
#include "report/figure/options.hpp"

namespace fpkcheck::report {

/// A gnuplot script that draws one case as the paper's Figs. 2-5 do: (a) p(y), (b) its logarithm,
/// (c) p(y'), (d) its logarithm; and beside them (e), (f) the differences from the reference, since
/// the curves themselves nearly coincide. In one column of a journal the logarithms and the
/// differences alone, one below another. It holds its data, and draws FILE_STEM.png or, with
/// format='svg', 'pdf' or 'tex', that; the gnuplot variable `target` names another file.
/// @param content with at least one side
std::string figure_script(const problem::Problem& problem, const FigureContent& content,
                          const std::string& file_stem, FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
