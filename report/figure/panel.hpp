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

/// Title, axes and plot command of one panel.
/// @param reference id of the solution that is subtracted in the differences
std::string panel_commands(Panel panel, const FigureSide& side, const std::string& reference);

}  // namespace fpkcheck::report
