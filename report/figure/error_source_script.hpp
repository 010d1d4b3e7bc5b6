#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether a case has error sources to draw.
bool has_error_sources(const results::Case& case_result);

/// A gnuplot script with heat maps of the error sources of E[y^2] (top, or left on paper) and
/// E[y'^2] in the phase plane. Shown are the closest closure of each formulation and the solutions
/// of the full problem, at most four; two in a single journal column.
std::string error_source_script(const results::Case& case_result, const std::string& file_stem,
                                FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
