#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of maps over the two varied keys, one for each method: the larger of both L1
/// distances to each point's reference as a colour, contours at 1 % and 5 % (of the design product,
/// over numbers), and marks where a status is not ok. Points of other designs are discs of that
/// colour.
/// @param view of a plan with two keys and a method to compare
std::string map_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
