#pragma once

#include <string>
#include <vector>

#include "problem/problem.hpp"
#include "report/figure/figure_options.hpp"
#include "report/figure/script_text.hpp"

/// Layout that all gnuplot pictures share: size, output commands, title, panels and legend.
namespace fpkcheck::report {

/// Size of the layout of a picture in pixels. The letters in a picture are 14 or 15 pixels high for
/// every picture width. A narrow picture has fewer panels side by side than a wide picture, since
/// its letters are equally high. Letters of a printed picture have a size of 7.5 pt.
struct FigureSize {
  int width;
  int height;
  FigureWidth medium = FigureWidth::screen;
};

/// Returns the width in pixels of the layout of a figure on a screen or in journal columns.
/// @param screen_width_pixels width of the picture on a screen, in pixels
int layout_width_in_pixels(FigureWidth medium, int screen_width_pixels);

/// Returns the printed width of a figure in mm; 0 for a figure on a screen.
double printed_width_mm(FigureWidth medium);

/// Returns the first commands of a gnuplot script, which set terminal and output. The script draws
/// FILE_STEM.png. The gnuplot variable format='svg', 'pdf' or 'tex' selects a format other than
/// PNG, and the gnuplot variable `target` another file name. The script refuses all other formats.
std::string gnuplot_output_commands(const std::string& file_stem, const FigureSize& size);

struct FigureTitle {
  std::string command;  ///< gnuplot command that begins the multiplot
  int height;           ///< height of the title in pixels
};

/// @param parts parts of the title in plain text, between which lines may break: "case1: c = 0.1,
///        ", "r = 0.98"
FigureTitle make_figure_title(const std::vector<std::string>& parts, const FigureSize& size);

/// Returns the name and the parameters of a problem as parts of the title of a figure.
std::vector<std::string> problem_title_parts(const problem::Problem& problem);

/// The layout of a figure in pixels: panels of equal size in rows and columns between title and
/// legend.
struct PanelGrid {
  FigureWidth medium = FigureWidth::screen;
  int width = 1100;  ///< width of the picture in pixels
  int columns = 1, rows = 1;
  int panel_height = 280;       ///< height of the axes of a panel
  int title_height = 36;        ///< height of the figure title
  int legend_height = 0;        ///< height of the legend at the bottom
  int above = 44;               ///< height of the title of a panel
  int below = 74;               ///< height of tics and axis label of a panel
  int right_margin = 15;        ///< right margin of the picture, for a common colour bar
  int panel_right_margin = 12;  ///< right margin of each panel, for its own colour bar

  /// Gnuplot commands that shift axis labels and panel titles, so that neighbouring rows of panels
  /// do not overlap. The label offset for LaTeX is fixed, since gnuplot cannot compute the width of
  /// tic labels set by LaTeX.
  static constexpr const char* kLabelOffsetCommands =
      "set xlabel offset 0,0.3\nset ylabel offset (format eq 'tex' ? -2.5 : 0),0\n"
      "set title offset 0,-0.4\nset cblabel offset 0.8,0\n";
  FigureSize size() const;
  FigurePanelBox panel_box(int row, int column) const;
  /// @param panel index of the panel, counted row by row from 0
  FigurePanelBox panel_box(std::size_t panel) const {
    return panel_box(static_cast<int>(panel) / columns, static_cast<int>(panel) % columns);
  }
};

/// Makes the panel grid of a figure for a medium (screen or journal column). A figure for a single
/// journal column has less space between its rows of panels than other figures.
/// @param screen_width_pixels width of the picture on a screen, in pixels
PanelGrid make_panel_grid(FigureWidth medium, int screen_width_pixels);

/// A legend entry: gnuplot's plot specification ("NaN with lines ..") and the label.
struct FigureLegendEntry {
  std::string plot;
  std::string label;
};

/// The legend of a figure. The legend of a figure is in a strip below all panels and covers no
/// curve.
struct FigureLegend {
  std::vector<FigureLegendEntry> entries;
  int sample_length;  ///< length of the line sample beside each label, in units of the letter width
};

/// Returns the height in pixels that the legend strip needs for all entries, since gnuplot omits
/// entries that do not fit.
int legend_height(const FigureLegend& legend, int width);

/// Returns gnuplot commands that draw the legend at the bottom of a figure, as the last plot of a
/// multiplot.
/// @param size size of the figure
std::string legend_strip_commands(const FigureLegend& legend, const FigureSize& size);

}  // namespace fpkcheck::report
