#pragma once

#include <string>

#include "results/run.hpp"

namespace fpkcheck::report {

/// True when there is something to draw.
bool has_sources(const results::Case& one);

/// Heat maps of where the errors of E[y^2] (above) and E[y'^2] (below) come from, in the closest
/// closure of each formulation and the solutions of the problem itself, four at most.
std::string sources_script(const results::Case& one, const std::string& file_stem);

}  // namespace fpkcheck::report
