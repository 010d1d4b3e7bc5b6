#pragma once

#include <string>

#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script that draws the L1 distances of both marginal densities to each point's
/// reference. Open marks show solutions that are not ok, and crosses at the top show solutions
/// without a density. Dotted lines show the error estimates of the methods, and a grey area shows
/// the error estimate of the reference.
/// @param view view of results with at least one method to compare
std::string distances_script(const SweepView& view, const CurvesLayout& layout,
                             const std::string& file_stem);

}  // namespace fpkcheck::sweep
