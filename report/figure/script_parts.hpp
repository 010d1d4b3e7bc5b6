#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/identity.hpp"
#include "transform/marginal.hpp"

/// Parts of gnuplot scripts: panel positions, data blocks, tics, point and dash types.
namespace fpkcheck::report {

/// The rectangle of the axes of a panel, in fractions of the picture.
struct PanelBox {
  double left, right, top, bottom;
};
/// Commands that set the position of a panel.
std::string margin_commands(const PanelBox& place);

/// A named data block of a script.
/// @param rows each ended by a newline
std::string data_block(const std::string& name, const std::string& rows);

/// The smallest tic distance of 1, 2 or 5 times a power of ten that divides a range into at most
/// `most_steps` steps.
double tic_step(double from, double to, int most_steps = 6);

/// "p(y)" or "p(y')" in enhanced text.
std::string density_symbol(transform::Variable variable);

/// Point types of gnuplot: filled for status ok, else open.
struct PointTypes {
  int filled, open;
};
/// The point types of the same shape as a marker of plotly.js (the symbol of a plot style).
PointTypes point_types(const std::string& symbol);

/// The dash type of a plot style. "solid" for an invalid dash type, which a file may contain.
std::string dash_type(const transform::PlotStyle& look);

/// Style of a series. Shapes of marks distinguish families, dashes their members, for grey print.
struct SeriesStyle {
  std::string colour;
  int filled, open;            ///< PointTypes
  std::string dash = "solid";  ///< dash type of the line
};

/// The styles of series of these solutions: colours, symbols and dashes of their plot styles.
std::vector<SeriesStyle> series_styles(std::span<const transform::Identity> identities);

}  // namespace fpkcheck::report
