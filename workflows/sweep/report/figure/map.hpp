#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script that draws a map over the two varied keys for each method. The colour shows the
/// larger of the L1 distances of both marginal densities to each point's reference. For the design
/// product with numeric keys the map has contours at 1 % and 5 %. Marks show statuses that are not
/// ok. For other designs the points are coloured discs.
/// @param view view of results with two varied keys and at least one method to compare
std::string map_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
