#pragma once

#include "report/figure/frame.hpp"
#include "report/figure/script_parts.hpp"

namespace fpkcheck::report {

/// Panels of the same size in rows below a title, above a legend. In pixels.
struct PanelGrid {
  FigureWidth medium = FigureWidth::screen;
  int width = 1100;  ///< of the picture
  int columns = 1, rows = 1;
  int panel_height = 280;  ///< of the axes alone
  int title_height = 36;   ///< FigureTitle
  int legend_height = 0;   ///< at the bottom
  int above = 44;          ///< a panel: its title
  int below = 74;          ///< a panel: tics and label
  int at_the_right = 15;   ///< what is left free there, for a colour bar
  int at_the_left = 0;     ///< and there, for a label of all rows
  int beside = 12;         ///< each panel, at its right: for a colour bar of its own

  /// Commands that keep labels and titles of neighbouring rows apart; how wide the tics of LaTeX
  /// are gnuplot does not know.
  static constexpr const char* kLabels =
      "set xlabel offset 0,0.3\nset ylabel offset (format eq 'tex' ? -2.5 : 0),0\n"
      "set title offset 0,-0.4\nset cblabel offset 0.8,0\n";
  FigureSize size() const;
  Place place(int row, int column) const;
  /// Row by row.
  Place place(std::size_t panel) const {
    return place(static_cast<int>(panel) / columns, static_cast<int>(panel) % columns);
  }
};

/// As wide as the picture is to be, in a single column with less between its rows where it is one
/// of a journal.
PanelGrid panel_grid(FigureWidth medium, int on_screen);

}  // namespace fpkcheck::report
