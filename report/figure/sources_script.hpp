#pragma once

#include <string>

#include "report/figure/options.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {

/// True when there is something to draw.
bool has_sources(const results::Case& one);

/// Heat maps of where the errors of E[y^2] (above, or at the left on paper) and E[y'^2] come from,
/// in the closest closure of each formulation and the solutions of the problem itself, four at
/// most; in one column of a journal two.
std::string sources_script(const results::Case& one, const std::string& file_stem,
                           FigureWidth width = FigureWidth::screen);

}  // namespace fpkcheck::report
