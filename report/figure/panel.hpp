#pragma once

#include <string>

#include "report/figure/content.hpp"

namespace fpkcheck::report {

/// The three views of one variable.
enum class Panel { linear, logarithmic, difference };

/// Name of a curve's data block in the script. Columns: abscissa, density, lower and upper end of
/// its 95 % interval, difference from the reference.
/// @param drawn one of the side's curves
std::string block_name(const FigureSide& side, const DrawnCurve& drawn);

/// The part of a plot command that sets how a curve looks.
std::string drawn_with(const transform::Look& look, bool with_interval);

/// Title, axes and plot command of one panel.
/// @param reference id of the solution that is subtracted in Panel::difference
std::string panel_commands(Panel panel, const FigureSide& side, const std::string& reference);

}  // namespace fpkcheck::report
