#pragma once

#include <string>

#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of the L1 distances of both marginals to each point's reference: marks are open
/// where an answer is not ok, dotted is what methods state of their own errors, grey what the
/// reference cannot tell, and crosses at the top are answers without a density.
/// @param view with a method to compare
std::string distances_script(const SweepView& view, const CurvesLayout& layout,
                             const std::string& file_stem);

}  // namespace fpkcheck::sweep
