#pragma once

#include "report/figure/frame.hpp"
#include "report/figure/script_parts.hpp"

namespace fpkcheck::sweep {

/// Panels of the same size in rows below a title, above a legend. In pixels.
struct PanelGrid {
  int columns, rows;
  int panel_height;       ///< of the axes alone
  int legend_height;      ///< at the bottom
  int at_the_right = 15;  ///< what is left free there, for a colour bar
  int at_the_left = 0;    ///< and there, for a label of all rows

  static constexpr int kWidth = 1100;
  /// Commands that keep labels and titles of neighbouring rows apart.
  static constexpr const char* kLabels =
      "set xlabel offset 0,0.3\nset ylabel offset 0.8,0\nset title offset 0,-0.4\n";
  report::FigureSize size() const;
  report::Place place(int row, int column) const;
  report::Place place(std::size_t panel) const {
    return place(static_cast<int>(panel) / columns, static_cast<int>(panel) % columns);
  }
};

}  // namespace fpkcheck::sweep
