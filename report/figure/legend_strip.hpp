#pragma once

#include <string>
#include <vector>

#include "report/figure/frame.hpp"

namespace fpkcheck::report {

/// An entry of a legend: plot specification ("NaN with lines ..") and label.
struct LegendEntry {
  std::string plot;
  std::string label;
};

/// The legend of a figure, in a strip below the panels, so that the legend covers no curve.
struct Legend {
  std::vector<LegendEntry> entries;
  int sample_length;  ///< length of the line sample beside each label, in letters
};

/// Height of the strip with all entries, in pixels: gnuplot omits entries that exceed the height.
int legend_height(const Legend& legend, int width);

/// Commands that draw the legend at the bottom of a figure, as the last plot of a multiplot.
/// @param size of the figure
std::string legend_strip(const Legend& legend, const FigureSize& size);

}  // namespace fpkcheck::report
