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

/// "p(y)" in enhanced text, y or y'.
std::string density_of(transform::Variable variable);

/// Marks differ by shape as well as by colour, for grey print.
struct SeriesLook {
  std::string colour;
  int filled, open;  ///< point types: filled where a density may be trusted
  int dash = 1;      ///< dash type of the line
};

/// Series look as the methods they stand for; those of one family differ in their dashes.
std::vector<SeriesLook> series_looks(std::span<const transform::Identity> identities);

}  // namespace fpkcheck::report
