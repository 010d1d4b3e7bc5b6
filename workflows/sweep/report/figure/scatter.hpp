#pragma once

#include <string>

#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script that draws scatter plots for plans with many keys: against each key, the larger
/// of the L1 distances of both marginal densities to each point's reference. Each point and method
/// has a mark, which is open if the solution is not ok. A line shows the medians of the solutions
/// that are ok, over bins of the key.
std::string scatter_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
