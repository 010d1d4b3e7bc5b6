#pragma once

#include <string>

#include "report/figure/content.hpp"

namespace fpkcheck::report {

/// The kind of a panel of one marginal density: the density on a linear or on a logarithmic axis,
/// the difference from the reference, or the absolute difference from the reference over smooth
/// bins.
enum class Panel { linear, logarithmic, difference, smooth_difference };

/// The name of the data block of a curve in the gnuplot script. The block has the columns abscissa,
/// density, and lower and upper end of the 95 % confidence interval.
/// @param drawn a curve of this marginal density
std::string block_name(const MarginalCurves& marginal, const DrawnCurve& drawn);
/// The name of the data block with the difference between a curve and the curve of the reference.
std::string difference_block_name(const MarginalCurves& marginal, const DrawnCurve& drawn);

/// The style of a curve as a part of a gnuplot plot command.
std::string curve_style(const transform::PlotStyle& plot_style, bool with_interval);

/// Whether the curve of a solution has marks, which distinguish curves in grey print. Closures and
/// external densities have marks; solutions of density equations have lines only.
bool has_marks(const transform::SolutionIdentity& identity);
/// The style of a solution's marks without the colour: filled marks for status ok, else open marks.
std::string mark_style(const transform::Solution& solution);

/// The line style of the reference in a panel of absolute differences, where the line shows the
/// half-width of the reference's confidence intervals.
inline constexpr const char* kReferenceIntervalStyle =
    "with lines linewidth 2 dashtype (1,3) linecolor rgb '#444444'";

/// The gnuplot commands for title, axes and curves of one panel.
/// @param letter letter of the panel, "(a)" in the title
/// @param reference id of the reference, whose density is subtracted in the differences
/// @param short_title whether the title is short, for a narrow panel
std::string panel_commands(Panel panel, const MarginalCurves& marginal, char letter,
                           const std::string& reference, bool short_title = false);

}  // namespace fpkcheck::report
