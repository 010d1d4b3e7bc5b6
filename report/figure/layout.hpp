#pragma once

#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "report/figure/script_parts.hpp"

/// Layout of a figure: the panels, and below them the legend.
namespace fpkcheck::report {

/// The layout of a figure, in pixels: panels of equal size in rows and columns between the title
/// and the legend.
struct PanelGrid {
  FigureWidth medium = FigureWidth::screen;
  int width = 1100;  ///< width of the picture
  int columns = 1, rows = 1;
  int panel_height = 280;       ///< height of the axes
  int title_height = 36;        ///< height of FigureTitle
  int legend_height = 0;        ///< height of the legend at the bottom
  int above = 44;               ///< height of the title of a panel
  int below = 74;               ///< height of tics and axis label of a panel
  int right_margin = 15;        ///< right margin of the picture, for a common colour bar
  int left_margin = 0;          ///< left margin of the picture, for a common label of the rows
  int panel_right_margin = 12;  ///< right margin of each panel, for its own colour bar

  /// gnuplot commands that shift labels and titles, so that neighbouring rows do not overlap. The
  /// label offset for LaTeX is fixed, since gnuplot does not compute the width of tic labels set by
  /// LaTeX.
  static constexpr const char* kLabels =
      "set xlabel offset 0,0.3\nset ylabel offset (format eq 'tex' ? -2.5 : 0),0\n"
      "set title offset 0,-0.4\nset cblabel offset 0.8,0\n";
  FigureSize size() const;
  PanelBox panel_box(int row, int column) const;
  /// @param panel index of the panel, counted row by row from 0
  PanelBox panel_box(std::size_t panel) const {
    return panel_box(static_cast<int>(panel) / columns, static_cast<int>(panel) % columns);
  }
};

/// Makes the panel grid of a figure with the width of a medium. A figure for a single journal
/// column has less space between the rows.
/// @param screen_width_pixels width of the picture on a screen, in pixels
PanelGrid panel_grid(FigureWidth medium, int screen_width_pixels);

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
