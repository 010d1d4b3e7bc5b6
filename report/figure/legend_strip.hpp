#pragma once

#include <string>
#include <vector>

#include "report/figure/frame.hpp"

namespace fpkcheck::report {

/// An entry of a legend: how it is drawn ("with lines .."), of what ("NaN"), and what it is called.
struct LegendEntry {
  std::string plot;
  std::string label;
};

/// The legend of a figure: a strip of its own below the panels, so that nothing is covered.
struct Legend {
  std::vector<LegendEntry> entries;
  int sample_length;  ///< of what is drawn beside each label, in letters
};

/// Pixels that it needs at the bottom of a figure for all its entries: gnuplot leaves out those
/// that do not fit.
int legend_height(const Legend& legend, int width);

/// Draws it there; the last plot of a multiplot.
/// @param size of the figure
std::string legend_strip(const Legend& legend, const FigureSize& size);

}  // namespace fpkcheck::report
