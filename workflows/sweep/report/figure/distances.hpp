#pragma once

#include <string>

#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of the L1 distances of both marginals to each point's reference. Open marks:
/// the solution is not ok. Dotted: error estimates of the methods. Grey: error estimate of the
/// reference. Crosses at the top: solutions without a density.
/// @param view must have a method to compare
std::string distances_script(const SweepView& view, const CurvesLayout& layout,
                             const std::string& file_stem);

}  // namespace fpkcheck::sweep
