#pragma once

#include <span>
#include <string>
#include <vector>

#include "transform/identity.hpp"
#include "transform/marginal.hpp"

/// What pictures over grids, orders and varied keys are made of: parts of gnuplot scripts.
namespace fpkcheck::report {

/// Where a panel stands, in fractions of the picture.
struct Place {
  double left, right, top, bottom;
};
std::string margins(const Place& place);

/// Named data within a script.
/// @param rows each ended by a newline
std::string data_block(const std::string& name, const std::string& rows);

/// A step of 1, 2 or 5 with zeros that makes at most so many steps of a range: the tics that a narrow
/// panel has room for.
double tic_step(double from, double to, int most_steps = 6);

/// "p(y)" in enhanced text, y or y'.
std::string density_of(transform::Variable variable);

/// Point types of gnuplot: filled where a density may be trusted, else open.
struct PointTypes {
  int filled, open;
};
/// Those that look as a marker of plotly.js (transform::Look::symbol) does.
PointTypes point_types(const std::string& symbol);

/// The dash type of a look, "solid" where it is none: a look may come from a file.
std::string dash_type(const transform::Look& look);

/// Marks tell families by their shape, dashes the members of one, for grey print.
struct SeriesLook {
  std::string colour;
  int filled, open;            ///< PointTypes
  std::string dash = "solid";  ///< dash type of the line
};

/// Series look as the methods they stand for.
std::vector<SeriesLook> series_looks(std::span<const transform::Identity> identities);

}  // namespace fpkcheck::report
