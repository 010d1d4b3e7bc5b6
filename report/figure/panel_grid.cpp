#include "report/figure/panel_grid.hpp"

namespace fpkcheck::report {
namespace {

// Left margin, in pixels, of a panel with tics and axis label, and of a panel with tics only.
constexpr int kLeft = 92, kTicsAlone = 52;

}  // namespace

FigureSize PanelGrid::size() const {
  const int row = above + panel_height + below;
  return {.width = width, .height = title_height + rows * row + legend_height, .medium = medium};
}

PanelBox PanelGrid::panel_box(int row, int column) const {
  const double height = size().height;
  const double of_a_column = static_cast<double>(width - left_margin - right_margin) / columns;
  const double top = title_height + row * (above + panel_height + below) + above;
  const int left = left_margin > 0 ? kTicsAlone : kLeft;
  return {.left = (left_margin + column * of_a_column + left) / width,
          .right = (left_margin + (column + 1) * of_a_column - panel_right_margin) / width,
          .top = 1 - top / height,
          .bottom = 1 - (top + panel_height) / height};
}

PanelGrid panel_grid(FigureWidth medium, int screen_width_pixels) {
  PanelGrid grid{.medium = medium, .width = figure_width(medium, screen_width_pixels)};
  if (medium == FigureWidth::one_column) {
    grid.above = 36;
    grid.below = 62;
  }
  return grid;
}

}  // namespace fpkcheck::report
