#include "workflows/sweep/report/figure/figure_scripts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "report/figure/frame.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_parts.hpp"
#include "report/figure/text.hpp"
#include "workflows/sweep/report/figure/map_data.hpp"
#include "workflows/sweep/report/figure/status_mark.hpp"

namespace fpkcheck::sweep {
using report::PanelGrid;
namespace {

using report::LegendEntry;
using transform::Status;

/// A contour level of the maps, with its line style.
struct ContourLevel {
  double l1;
  const char* name;
  const char* style;
};
constexpr ContourLevel kContourLevels[] = {
    {0.01, "one", "with lines lc rgb '#08306B' lw 2 dt solid"},
    {0.05, "five", "with lines lc rgb '#08306B' lw 2.6 dt (8,5)"}};

// The style of the outline around cells with a status that is not ok.
constexpr const char* kOutline = "with lines lc rgb 'black' lw 0.8";

// The background is grey, since light discs would be invisible on white.
constexpr const char* kBackground =
    "set object rectangle from graph 0,0 to graph 1,1 behind fc rgb '#E4E4E4' fs noborder\n";

PanelGrid map_grid(const SweepView& view, std::size_t panels) {
  const int count = static_cast<int>(panels);
  PanelGrid grid{.medium = view.medium(), .width = view.width()};
  grid.title_height = view.title().height;
  grid.columns = view.medium() == report::FigureWidth::one_column ? 1
                 : count <= 3                                     ? count
                 : count == 4                                     ? 2
                 : count <= 6                                     ? 3
                                                                  : 4;
  grid.rows = (count + grid.columns - 1) / grid.columns;
  grid.panel_height = grid.columns <= 2 ? 300 : grid.columns == 3 ? 240 : 190;
  grid.right_margin = 105;
  grid.left_margin = 36;
  return grid;
}

// The colours range from light (but not white) to dark, so that grey print keeps the order of the
// values. All colours are light enough for black marks.
std::string colour_scale(const PanelGrid& grid) {
  const auto first = grid.panel_box(0, grid.columns - 1), last = grid.panel_box(grid.rows - 1, 0);
  return fmt::format(
      "set palette defined (0 '#FFF0A8', 1 '#FED976', 2 '#FDAE5B', 3 '#F07C3C', 4 '#CF2A1E')\n"
      "set logscale cb\nset cbrange [{}:1]\nset format cb {}\n"
      "set cblabel {}\n"
      "set colorbox user origin screen {:.4f},{:.4f} size screen 0.014,{:.4f}\n",
      kMinColourDistance, report::kPowerOfTenFormat,
      report::gnuplot_text("larger {/:Italic L}_1 distance"), first.right + 0.022, last.bottom,
      first.top - last.bottom);
}

// A map with few cells is drawn as rectangles in SVG, since SVG viewers smooth images. In PNG the
// map is drawn as an image, since rectangles would have visible seams.
std::string cell_drawing_option(std::size_t cells) {
  constexpr std::size_t kFew = 6000;
  return fmt::format("cells = format eq 'svg' ? '{}' : ''\n", cells <= kFew ? "pixels" : "");
}

std::string cells_plot(const MapData& map, std::size_t m) {
  // A single row or column of cells is drawn as rectangles, since gnuplot cannot draw such an
  // image.
  const bool is_image = map.x().values().size() > 1 && map.y().values().size() > 1;
  return fmt::format("$map_{} using {} notitle", m,
                     is_image ? "1:2:3 with image @cells"
                              : "1:2:(0.5):(0.5):3 with boxxyerror fs solid noborder lc palette");
}

std::string discs_plot(std::size_t m, double size) {
  return fmt::format("$map_{0} using 1:2:3 with points pt 7 ps {1:.3g} lc palette notitle", m,
                     size);
}

// The contours are computed from the logarithms of the distances.
std::string contour_commands(std::size_t m, const ContourLevel& level) {
  return fmt::format(
      "set cntrparam levels discrete {0:.6g}\nset table $contour_{1}_{2}\n"
      "splot $map_{2} using 1:2:(log10($3))\nunset table\n",
      std::log10(level.l1), level.name, m);
}

// The number of marks that fit side by side into a panel.
std::size_t marks_per_length(double pixels) {
  constexpr double kMarkSpacing = 15;
  return static_cast<std::size_t>(std::max(1.0, pixels / kMarkSpacing));
}

// The size of discs in gnuplot's unit of point sizes. The size decreases with the number of points,
// so that discs do not overlap.
double disc_size(std::size_t points) {
  return std::clamp(36 / std::sqrt(static_cast<double>(points)), 0.5, 1.6);
}

report::Legend map_legend(const MapData& map, const std::vector<std::size_t>& methods) {
  const SweepView& view = map.view();
  report::Legend legend{{}, 3};
  for (const auto& level : kContourLevels) {
    if (std::ranges::none_of(methods,
                             [&](std::size_t m) { return map.has_contour(m, level.l1); })) {
      continue;
    }
    legend.entries.push_back(
        {fmt::format("NaN {}", level.style), fmt::format("{:g} %", 100 * level.l1)});
  }
  std::vector<Status> statuses;
  bool any_reference = false, any_empty = !view.results().is_complete();
  for (const std::size_t m : methods) {
    for (const auto& point : view.results().points) {
      statuses.push_back(point.methods[m].status);
      const bool is_reference = view.is_reference(point.point, m);
      any_reference = any_reference || is_reference;
      any_empty = any_empty || !view.larger_l1(point.point, m);
    }
  }
  if (std::ranges::any_of(methods, [&](std::size_t m) { return !map.outline_block(m).empty(); })) {
    legend.entries.push_back({fmt::format("NaN {}", kOutline), "outline: not ok"});
  }
  std::ranges::move(status_legend(statuses), std::back_inserter(legend.entries));
  if (any_reference)
    legend.entries.push_back({"NaN " + mark_style(kReferenceMark), "the reference"});
  if (any_empty && map.has_cells()) {
    legend.entries.push_back({"NaN with boxes lc rgb '#777777' fs empty", "white: no distance"});
  }
  return legend;
}

// The data blocks and the plot commands of one panel.
struct MapPanel {
  std::string data, contours;
  std::vector<std::string> plots;
};

MapPanel map_panel(const MapData& map, const PanelGrid& grid, std::size_t m) {
  const std::size_t points =
      map.view().plan().points.size() * static_cast<std::size_t>(grid.columns);
  const double disc = disc_size(points);
  MapPanel panel{map.blocks(m), "", {}};
  panel.plots.push_back(map.has_cells() ? cells_plot(map, m) : discs_plot(m, disc));
  if (const std::string outline = map.outline_block(m); !outline.empty()) {
    panel.data += outline;
    panel.plots.push_back(fmt::format("$outline_{} using 1:2 {} notitle", m, kOutline));
  }
  for (const auto& level : kContourLevels) {
    if (!map.has_contour(m, level.l1)) continue;  // gnuplot warns about an empty table
    panel.contours += contour_commands(m, level);
    panel.plots.push_back(
        fmt::format("$contour_{}_{} using 1:2 {} notitle", level.name, m, level.style));
  }
  const auto place = grid.panel_box(0, 0);
  std::set<int> types;
  panel.data += map.mark_blocks(m, marks_per_length((place.right - place.left) * grid.width),
                                marks_per_length(grid.panel_height), types);
  for (const int type : types) {
    panel.plots.push_back(fmt::format("$mark_{}_{} using 1:2 {} notitle", m, type,
                                      mark_style(type, map.has_cells() ? 0.9 : 0.75 * disc)));
  }
  return panel;
}

}  // namespace

std::string map_script(const SweepView& view, const std::string& file_stem) {
  const MapData map(view);
  const auto methods = view.compared_methods();
  const report::Legend legend = map_legend(map, methods);
  PanelGrid grid = map_grid(view, methods.size());
  grid.legend_height = report::legend_height(legend, grid.width);
  const std::string axes = map.has_cells()
                               ? map.x().cell_axis_commands('x') + map.y().cell_axis_commands('y')
                               : map.x().commands('x') + map.y().commands('y');
  std::string data, contours, panels;
  for (std::size_t k = 0; k < methods.size(); ++k) {
    const MapPanel panel = map_panel(map, grid, methods[k]);
    data += panel.data;
    contours += panel.contours;
    const auto column = k % static_cast<std::size_t>(grid.columns);
    panels += fmt::format("set title {}\n{}{}plot {}\n{}\n",
                          report::gnuplot_literal(view.plan().methods[methods[k]].id()),
                          report::panel_position_commands(grid.panel_box(k)),
                          column == 0 ? map.y().label_command('y') : "unset ylabel\n",
                          fmt::join(panel.plots, ", \\\n     "), k == 0 ? "unset colorbox\n" : "");
  }
  if (!contours.empty()) {
    contours = "set contour base\nunset surface\n" + contours + "unset contour\nset surface\n";
  }
  return report::gnuplot_output_commands(file_stem, grid.size()) + data + contours +
         cell_drawing_option(view.plan().points.size() * methods.size()) + PanelGrid::kLabels +
         "set tics out nomirror\nunset key\n" + colour_scale(grid) + view.title().command + axes +
         (map.has_cells() ? "" : kBackground) + panels + "unset object\n" +
         (legend.entries.empty() ? "" : report::legend_strip_commands(legend, grid.size())) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::sweep
