#pragma once

#include <string>

#include "compare/transient/run.hpp"

namespace fpkcheck::compare {

/// A gnuplot script that draws (a) p(y, t) and (b) p(y', t) as colour maps over time. It holds its
/// data, and draws FILE_STEM.png or, with format='svg', FILE_STEM.svg; the gnuplot variable
/// `target` names another file.
/// @param run with at least two snapshots
std::string transient_figure(const TransientRun& run, const std::string& file_stem);

}  // namespace fpkcheck::compare
