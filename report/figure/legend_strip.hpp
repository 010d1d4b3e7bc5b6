#pragma once

#include <string>
#include <vector>

#include "report/figure/frame.hpp"

namespace fpkcheck::report {

/// An entry of the legend of a figure: plot specification ("NaN with lines ..") and label.
struct LegendEntry {
  std::string plot;
  std::string label;
};

/// The legend of a figure. The legend is in a strip below the panels, so that no curve is covered.
struct Legend {
  std::vector<LegendEntry> entries;
  int sample_length;  ///< length of the line sample beside each label, in letters
};

/// Height in pixels of a strip that shows all entries of the legend: gnuplot omits entries that do
/// not fit into the strip.
int legend_height(const Legend& legend, int width);

/// gnuplot commands that draw the legend at the bottom of a figure, as the last plot of a
/// multiplot.
/// @param size size of the figure
std::string legend_strip_commands(const Legend& legend, const FigureSize& size);

}  // namespace fpkcheck::report
