#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of maps over the two varied keys, one for each method. Colour: the larger of
/// both L1 distances to each point's reference. For the design product over numbers there are
/// contours at 1 % and 5 %. Marks show statuses that are not ok. Points of other designs are
/// coloured discs.
/// @param view must have a plan with two keys, and a method to compare
std::string map_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
