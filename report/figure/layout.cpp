#include "report/figure/layout.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/figure/text.hpp"

namespace fpkcheck::report {
namespace {

// Left margin, in pixels, of a panel with tics and axis label, and of a panel with tics only.
constexpr int kLeft = 92, kTicsAlone = 52;

// Letter width and line height, in pixels, that gnuplot assumes for the larger font, which is the
// font of the SVG.
constexpr double kLetter = 10.5, kLine = 25.2;
constexpr double kMargin = 16;
constexpr double kStripLeft = 0.02, kStripRight = 0.98;  // fractions of the width
constexpr int kMostColumns = 4;

int columns(const Legend& legend, int width) {
  std::size_t longest = 0;
  for (const auto& entry : legend.entries) longest = std::max(longest, entry.label.size());
  const double entry_width = kLetter * (static_cast<double>(longest) + legend.sample_length + 1);
  return std::clamp(static_cast<int>((kStripRight - kStripLeft) * width / entry_width), 1,
                    kMostColumns);
}

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

int legend_height(const Legend& legend, int width) {
  const auto rows = std::ceil(static_cast<double>(legend.entries.size()) / columns(legend, width));
  return static_cast<int>(std::ceil(kMargin + kLine * rows));
}

std::string legend_strip_commands(const Legend& legend, const FigureSize& size) {
  std::vector<std::string> plots;
  for (const auto& [plot, label] : legend.entries) {
    plots.push_back(fmt::format("{} title {}", plot, gnuplot_literal(label)));
  }
  const double top = legend_height(legend, size.width) - kMargin / 4, bottom = kMargin / 4;
  return fmt::format(
      "unset title\nunset xlabel\nunset ylabel\nunset border\nunset tics\nunset grid\n"
      "unset logscale\n"
      "set lmargin at screen {}\nset rmargin at screen {}\n"
      "set tmargin at screen {:.4f}\nset bmargin at screen {:.4f}\n"
      "set key center center horizontal maxcols {} Left reverse samplen {} spacing (format eq 'tex' ? 1.8 : 1.2)\n"
      "plot [0:1] [0:1] {}\n",
      kStripLeft, kStripRight, top / size.height, bottom / size.height, columns(legend, size.width),
      legend.sample_length, fmt::join(plots, ", \\\n     "));
}

}  // namespace fpkcheck::report
