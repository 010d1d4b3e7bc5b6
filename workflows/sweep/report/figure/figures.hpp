#pragma once

#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// Draws the L1 distances of both marginal densities to each point's reference, along a varied key.
/// Open marks show solutions that are not ok, and crosses at the top show solutions without a
/// density. Dotted lines show the error estimates of the methods, and a grey area shows the error
/// estimate of the reference. Each value of a second, categorical key has a row of panels.
/// @param view results with at least one method to compare
report::Figure distance_curves_figure(const SweepView& view);

/// Draws E[y^2] and E[y'^2] along a varied key. Open marks show solutions that are not ok. The
/// ranges of the axes contain only the curves of the solutions that are ok.
report::Figure moment_curves_figure(const SweepView& view);

/// Draws a map over the two varied keys for each method. The colour shows the larger of the L1
/// distances of both marginal densities to each point's reference. The map of the design product
/// with numeric keys has contours at 1 % and 5 %. Marks show statuses that are not ok. Maps of
/// other designs have a coloured disc at each point.
/// @param view results with two varied keys and at least one method to compare
report::Figure distance_map_figure(const SweepView& view);

/// Draws a scatter plot against each key, for plans with many keys. The ordinate is the larger of
/// the L1 distances of both marginal densities to each point's reference. Open marks show solutions
/// that are not ok. A line shows the medians of the solutions that are ok, over bins of the key.
report::Figure distance_scatter_figure(const SweepView& view);

/// Returns the logarithmic axis of the L1 distances. The axis has at most eight decades and ends
/// near 20, since solutions that are not ok may have any distance.
/// @param rows_above number of rows of marks for which the axis has space above the distances
report::FigureAxis l1_distance_axis(const std::string& label,
                                    const std::vector<report::FigurePanel>& panels,
                                    std::size_t rows_above = 0);
/// Returns the ordinate of a row of marks above the distances.
/// @param row index of the row, counted from the top
double mark_row_ordinate(const report::FigureAxis& axis, std::size_t row);

}  // namespace fpkcheck::sweep
