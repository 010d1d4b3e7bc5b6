#pragma once

#include <string>

#include "report/figure/content.hpp"

namespace fpkcheck::report {

/// The panels of one marginal: the density on linear and logarithmic axes, its difference from the
/// reference, or the absolute difference over smooth bins.
enum class Panel { linear, logarithmic, difference, smooth_difference };

/// Name of the data block of a curve in the script. Columns: abscissa, density, lower and upper end
/// of the 95 % confidence interval.
/// @param drawn a curve of the marginal
std::string block_name(const MarginalCurves& marginal, const DrawnCurve& drawn);
/// Name of the data block of the difference of a curve from the reference.
std::string difference_block_name(const MarginalCurves& marginal, const DrawnCurve& drawn);

/// The style of a curve as a part of a plot command.
std::string curve_style(const transform::PlotStyle& look, bool with_interval);

/// Whether a curve has marks, which distinguish curves in grey print: closures and external
/// densities. Density equations have lines only.
bool has_marks(const transform::Identity& identity);
/// The style of these marks without the colour: filled for status ok, else open.
std::string mark_style(const transform::Solution& solution);

/// Style of the reference among absolute differences: the half-width of its confidence intervals.
inline constexpr const char* kReferenceIntervalStyle =
    "with lines linewidth 2 dashtype (1,3) linecolor rgb '#444444'";

/// Title, axes and plot command of one panel.
/// @param letter of the panel, "(a)" in the title
/// @param reference id of the solution subtracted in the differences
/// @param short_title short title, for a narrow panel
std::string panel_commands(Panel panel, const MarginalCurves& marginal, char letter,
                           const std::string& reference, bool short_title = false);

}  // namespace fpkcheck::report
