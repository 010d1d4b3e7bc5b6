#pragma once

#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"

namespace fpkcheck::sweep {

/// The L1 distances of both marginal densities to each point's reference, along a varied key. Open
/// marks show solutions that are not ok, and crosses at the top show solutions without a density.
/// Dotted lines show the error estimates of the methods, and a grey area shows the error estimate
/// of the reference. Each value of a second, categorical key has a row of panels.
/// @param view view of results with at least one method to compare
report::Figure distances_figure(const SweepView& view);

/// E[y^2] and E[y'^2] along a varied key. Open marks show solutions that are not ok. The axes
/// contain the curves of the solutions that are ok; other curves may exceed the axes.
report::Figure moments_figure(const SweepView& view);

/// A map over the two varied keys for each method. The colour shows the larger of the L1 distances
/// of both marginal densities to each point's reference. For the design product with numeric keys
/// the map has contours at 1 % and 5 %. Marks show statuses that are not ok. For other designs the
/// points are coloured discs.
/// @param view view of results with two varied keys and at least one method to compare
report::Figure map_figure(const SweepView& view);

/// Scatter plots for plans with many keys: against each key, the larger of the L1 distances of both
/// marginal densities to each point's reference. Each point and method has a mark, which is open if
/// the solution is not ok. A line shows the medians of the solutions that are ok, over bins of the
/// key.
report::Figure scatter_figure(const SweepView& view);

/// The logarithmic axis of the distances in all panels of a figure. The axis has at most eight
/// decades and ends near 20, since solutions that are not ok may have any distance.
/// @param rows_above number of rows of marks for which the axis has space above the distances
report::FigureAxis distance_axis(const std::string& label,
                                 const std::vector<report::FigurePanel>& panels,
                                 std::size_t rows_above = 0);
/// The ordinate of a row of marks above the distances.
/// @param row index of the row, from the top
double row_ordinate(const report::FigureAxis& axis, std::size_t row);

}  // namespace fpkcheck::sweep
