#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/figure/figure.hpp"
#include "report/figure/figure_options.hpp"
#include "report/figure/run_gnuplot.hpp"
#include "workflows/sweep/report/figure/sweep_view.hpp"
#include "workflows/sweep/result/sweep_results.hpp"

namespace fpkcheck::sweep {

/// Draws the L1 distances of p(y) and p(y') from the reference solution of each sweep point, as
/// functions of a varied key. Open marks in the figure show solutions that are not ok, and crosses
/// at the top show solutions without a density. Dotted lines show the error estimates of the
/// methods, and a grey area shows the error estimate of the reference solution. Each value of a
/// second, categorical varied key has a row of panels.
/// @param view results with at least one method to compare
report::Figure distance_curves_figure(const SweepResultsView& view);

/// Draws E[y^2] and E[y'^2] as functions of the varied key of a sweep. Open marks in the figure
/// show solutions with a status other than `ok`. Only solutions with the status `ok` determine the
/// axis ranges.
report::Figure moment_curves_figure(const SweepResultsView& view);

/// Draws, for each method of a sweep, a map over the two varied keys. The colour of a map shows the
/// larger of the L1 distances of p(y) and p(y') from the reference solution of each sweep point.
/// For the design `product` with numerical keys, contours in the map show L1 distances of 1 % and 5
/// %. Marks show statuses other than `ok`. For designs other than `product`, each sweep point is a
/// coloured disc.
/// @param view results with two varied keys and at least one method to compare
report::Figure distance_map_figure(const SweepResultsView& view);

/// Draws scatter plots of L1 distances against each varied key, for sweeps with many keys. The
/// ordinate of a scatter plot is the larger of the L1 distances of p(y) and p(y') from the
/// reference solution of each sweep point. Open marks in a scatter plot show solutions with a
/// status other than `ok`. A line in a scatter plot shows medians of the `ok` solutions over bins
/// of the varied key.
report::Figure distance_scatter_figure(const SweepResultsView& view);

/// Returns the logarithmic axis of the L1 distances in a figure of a sweep. The axis of L1
/// distances has at most eight decades and an upper end near 20, since solutions that are not `ok`
/// may have arbitrary distances.
/// @param rows_above number of rows of marks that need space above the distances
report::FigureAxis l1_distance_axis(const std::string& label,
                                    const std::vector<report::FigurePanel>& panels,
                                    std::size_t rows_above = 0);
/// Returns the ordinate of a row of marks above the L1 distances in a figure.
/// @param row index of the row, counted from the top
double status_mark_row_ordinate(const report::FigureAxis& axis, std::size_t row);

struct SweepFigure : report::PictureGnuplotScript {
  std::string caption;  ///< description of the figure in sentences
};

/// Returns the figures of a sweep: curves for one varied key, maps for two keys, and scatter plots
/// for three or more keys.
std::vector<SweepFigure> sweep_figures(const SweepResults& results,
                                       report::FigureWidth width = report::FigureWidth::screen);

/// Writes the gnuplot script STEM.gp of each sweep figure, draws the figure, and removes figures
/// that belong to another plan.
/// @return a warning for each picture that was not drawn; a single warning if gnuplot is missing
std::vector<std::string> draw_sweep_figures(const std::filesystem::path& figures,
                                            const std::vector<SweepFigure>& pictures,
                                            const report::FigureOptions& options = {},
                                            const std::string& gnuplot = "gnuplot");

}  // namespace fpkcheck::sweep
