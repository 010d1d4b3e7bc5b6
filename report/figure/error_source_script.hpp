#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// Whether a case has error sources (maps of the error of a moment over the phase plane) to draw.
bool has_error_sources(const results::CaseResult& case_result);

/// A gnuplot script that draws heat maps of the error sources of E[y^2] and E[y'^2] in the phase
/// plane, with the map of E[y^2] above the map of E[y'^2], or left of that map on paper. The figure
/// shows the closest closure of each formulation and the solutions of the full problem: at most
/// four solutions, or two solutions in a single journal column.
std::string error_source_script(const results::CaseResult& case_result,
                                const std::string& file_stem,
                                FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
