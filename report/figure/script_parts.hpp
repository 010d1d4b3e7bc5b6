#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/identity.hpp"
#include "transform/marginal.hpp"

/// Parts of gnuplot scripts: panel positions, data blocks, tics, point and dash types.
namespace fpkcheck::report {

/// The rectangle of the axes of a panel, as fractions of the picture's width and height.
struct PanelBox {
  double left, right, top, bottom;
};
/// gnuplot commands that set the position of a panel.
std::string panel_position_commands(const PanelBox& place);

/// A named data block of a gnuplot script.
/// @param rows rows of the block, each ended by a newline
std::string data_block(const std::string& name, const std::string& rows);

/// The smallest tic distance that divides an axis range into at most `max_steps` steps and is 1, 2
/// or 5 times a power of ten.
double tic_step(double from, double to, int max_steps = 6);

/// The symbol of a marginal density in gnuplot's enhanced text: "p(y)" or "p(y')".
std::string density_symbol(transform::Variable variable);

/// The gnuplot point types of one shape: the filled type for status ok, and the open type for other
/// statuses.
struct PointTypes {
  int filled, open;
};
/// The gnuplot point types with the shape of a plotly.js marker (the symbol of a plot style).
PointTypes point_types(const std::string& symbol);

/// The dash type of gnuplot; "solid" if the dash type is invalid, since a file may contain an
/// invalid dash type.
std::string dash_type(const std::string& dash);

/// The plot style of a series of points. In grey print the shapes of marks distinguish families,
/// and the dash types distinguish members of a family.
struct SeriesStyle {
  std::string colour;
  int filled, open;            ///< PointTypes
  std::string dash = "solid";  ///< dash type of the line
};

/// The series style of each solution, with colour, symbol and dash type of the solution's plot
/// style.
std::vector<SeriesStyle> series_styles(std::span<const transform::SolutionIdentity> identities);

}  // namespace fpkcheck::report
