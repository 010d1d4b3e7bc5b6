#include "sweep/report/figure/panel_grid.hpp"

namespace fpkcheck::sweep {
namespace {

// Of the larger font, that of the SVG.
constexpr int kFigureTitle = 36, kPanelTitle = 44, kBelow = 74, kRight = 12;
// Of a panel with a label of its own, and of one without.
constexpr int kLeft = 92, kTicsAlone = 52;

}  // namespace

report::FigureSize PanelGrid::size() const {
  const int row = kPanelTitle + panel_height + kBelow;
  return {.width = kWidth, .height = kFigureTitle + rows * row + legend_height};
}

report::Place PanelGrid::place(int row, int column) const {
  const double width = kWidth, height = size().height;
  const double of_a_column = (width - at_the_left - at_the_right) / columns;
  const double top = kFigureTitle + row * (kPanelTitle + panel_height + kBelow) + kPanelTitle;
  const int beside = at_the_left > 0 ? kTicsAlone : kLeft;
  return {.left = (at_the_left + column * of_a_column + beside) / width,
          .right = (at_the_left + (column + 1) * of_a_column - kRight) / width,
          .top = 1 - top / height,
          .bottom = 1 - (top + panel_height) / height};
}

}  // namespace fpkcheck::sweep
