#pragma once

#include <string>

#include "workflows/sweep/report/figure/curves_layout.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// A gnuplot script of E[y^2] and E[y'^2]. Open marks: the solution is not ok. The axes cover the
/// solutions that are ok; other curves may leave them.
std::string moments_script(const SweepView& view, const CurvesLayout& layout,
                           const std::string& file_stem);

}  // namespace fpkcheck::sweep
