#pragma once

#include <string>

#include "report/figure/content.hpp"

namespace fpkcheck::report {

/// The views of one variable: the density, and its difference from the reference, or the size of
/// that over smooth bins.
enum class Panel { linear, logarithmic, difference, smooth_difference };

/// Name of a curve's data block in the script. Columns: abscissa, density, lower and upper end of
/// its 95 % interval.
/// @param drawn one of the side's curves
std::string block_name(const FigureSide& side, const DrawnCurve& drawn);
/// The same of its difference from the reference.
std::string difference_block_name(const FigureSide& side, const DrawnCurve& drawn);

/// The part of a plot command that sets how a curve looks.
std::string drawn_with(const transform::Look& look, bool with_interval);

/// Whether some points of a curve are marked, so that it is known in grey print as well: those of
/// assumed forms and from files. Density equations are lines alone.
bool is_marked(const transform::Identity& identity);
/// How those points look but for their colour: filled where the density may be trusted.
std::string marked_with(const transform::Solution& solution);

/// How the reference is drawn among sizes of differences: half the width of its intervals.
inline constexpr const char* kOwnWidth =
    "with lines linewidth 2 dashtype (1,3) linecolor rgb '#444444'";

/// Title, axes and plot command of one panel.
/// @param letter that the panel is known by
/// @param reference id of the solution that is subtracted in the differences
/// @param briefly a title that fits a narrow panel
std::string panel_commands(Panel panel, const FigureSide& side, char letter,
                           const std::string& reference, bool briefly = false);

}  // namespace fpkcheck::report
