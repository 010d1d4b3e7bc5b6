#pragma once

#include <string>

#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script that draws E[y^2] and E[y'^2] along a varied key. Open marks show solutions
/// that are not ok. The axes contain the curves of the solutions that are ok; other curves may
/// exceed the axes.
std::string moments_script(const SweepView& view, const CurvesLayout& layout,
                           const std::string& file_stem);

}  // namespace fpkcheck::sweep
