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

/// A gnuplot script that draws a map over the two varied keys for each method. The colour shows the
/// larger of the L1 distances of both marginal densities to each point's reference. For the design
/// product with numeric keys the map has contours at 1 % and 5 %. Marks show statuses that are not
/// ok. For other designs the points are coloured discs.
/// @param view view of results with two varied keys and at least one method to compare
std::string map_script(const SweepView& view, const std::string& file_stem);

/// A gnuplot script that draws E[y^2] and E[y'^2] along a varied key. Open marks show solutions
/// that are not ok. The axes contain the curves of the solutions that are ok; other curves may
/// exceed the axes.
std::string moments_script(const SweepView& view, const CurvesLayout& layout,
                           const std::string& file_stem);

/// A gnuplot script that draws scatter plots for plans with many keys: against each key, the larger
/// of the L1 distances of both marginal densities to each point's reference. Each point and method
/// has a mark, which is open if the solution is not ok. A line shows the medians of the solutions
/// that are ok, over bins of the key.
std::string scatter_script(const SweepView& view, const std::string& file_stem);

}  // namespace fpkcheck::sweep
