#include "workflows/study/transient/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "report/figure/layout.hpp"
#include "report/figure/text.hpp"
#include "workflows/study/plot_series.hpp"

namespace fpkcheck::study {
namespace {

using fd_fpk::Snapshot;

// The numbers of pixels of a colour map, which equal the resolution of the drawn figure.
constexpr int kMaxColumns = 400;
constexpr int kPixelRows = 200;

/// A panel of the figure: the colour map of a marginal density over (t, x), with x = y or x = y'.
struct DensityMap {
  std::string block;  ///< name of its data block in the script
  std::string title;
  std::string symbol;
  double from = 0, to = 0;                      ///< drawn range of x
  std::vector<std::vector<double>> times = {};  ///< for each column of pixels, kPixelRows densities
  double largest = 0;
};

// Interpolates the cell averages linearly between the cells' centres.
double interpolate(std::span<const double> edges, std::span<const double> averages, double x) {
  const auto centre = [&](std::size_t b) { return (edges[b] + edges[b + 1]) / 2; };
  std::size_t b = std::upper_bound(edges.begin() + 1, edges.end() - 1, x) - edges.begin() - 1;
  if (x < centre(b) && b > 0) --b;
  if (b + 1 == averages.size()) --b;
  const double weight = std::clamp((x - centre(b)) / (centre(b + 1) - centre(b)), 0.0, 1.0);
  return (1 - weight) * averages[b] + weight * averages[b + 1];
}

DensityMap density_map(const TransientRun& run, DensityMap map, const std::vector<double>& edges,
                       std::vector<double> Snapshot::*marginal) {
  constexpr double kVisible = 2e-3;  // fraction of the largest density that is drawn
  const auto& snapshots = run.result.snapshots;
  for (const auto& s : snapshots)
    map.largest = std::max(map.largest, std::ranges::max(s.*marginal));
  map.from = edges.back();
  map.to = edges.front();
  for (const auto& s : snapshots) {
    for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
      if ((s.*marginal)[b] < kVisible * map.largest) continue;
      map.from = std::min(map.from, edges[b]);
      map.to = std::max(map.to, edges[b + 1]);
    }
  }
  // The snapshots are evenly spaced in time. If the run has more snapshots than the map has columns
  // of pixels, the columns are interpolated.
  const int last = static_cast<int>(snapshots.size()) - 1;
  const int columns = std::min(last, kMaxColumns - 1);
  for (int c = 0; c <= columns; ++c) {
    const double place = static_cast<double>(c) * last / columns;
    const int before = std::min(static_cast<int>(place), last - 1);
    const double weight = place - before;
    std::vector<double> column;
    for (int h = 0; h < kPixelRows; ++h) {
      const double x = map.from + (map.to - map.from) * (h + 0.5) / kPixelRows;
      column.push_back((1 - weight) * interpolate(edges, snapshots[before].*marginal, x) +
                       weight * interpolate(edges, snapshots[before + 1].*marginal, x));
    }
    map.times.push_back(std::move(column));
  }
  return map;
}

std::string data(const DensityMap& map) {
  std::string rows;
  for (const auto& column : map.times) {
    for (std::size_t h = 0; h < column.size(); ++h) {
      rows += fmt::format("{}{:.4g}", h == 0 ? "" : " ", column[h]);
    }
    rows += '\n';
  }
  return data_block(map.block, rows);
}

std::string settings() {
  return "# Rows: times; columns: abscissae. Both evenly spaced.\n"
         "set palette defined (0 '#FFFFFF', 0.04 '#E4F0EE', 0.12 '#A9DAC9', 0.3 '#45B29D', "
         "0.5 '#2A788E', 0.75 '#3B4A8C', 1 '#3A0F4F')\n"
         "set tics out nomirror\n"
         "set xlabel say('{/:Italic t}', '$t$')\n";
}

std::string panel(const DensityMap& map, double until, const report::PanelBox& place) {
  const double time_step = until / static_cast<double>(map.times.size() - 1);
  const double height = (map.to - map.from) / kPixelRows;
  return fmt::format(
      "set title '{0}'\n{1}"
      "set xrange [0:{2:.6g}]\nset yrange [{3:.6g}:{4:.6g}]\nset cbrange [0:{5:.6g}]\n"
      "set ylabel {6}\nset cblabel {7}\n"
      "plot ${8} using ($2*{9:.8g}):({10:.8g}+$1*{11:.8g}):3 matrix with image notitle\n\n",
      map.title, panel_position_commands(place), until, map.from, map.to, map.largest,
      report::gnuplot_text(map.symbol),
      report::gnuplot_text(fmt::format("{{/:Italic p}}({}, {{/:Italic t}})", map.symbol)),
      map.block, time_step, map.from + height / 2, height);
}

}  // namespace

std::string transient_figure(const TransientRun& run, const std::string& file_stem,
                             report::FigureWidth width) {
  constexpr int kScreenWidth = 1100, kColourBar = 130;
  const DensityMap y = density_map(run, {"p_y", "(a) displacement", "{/:Italic y}"},
                                   run.result.y_edges, &Snapshot::y);
  const DensityMap v = density_map(run, {"p_ydot", "(b) velocity", "{/:Italic y}'"},
                                   run.result.v_edges, &Snapshot::v);
  const double until = run.result.snapshots.back().time;
  report::PanelGrid grid = report::panel_grid(width, kScreenWidth);
  grid.rows = 2;
  grid.panel_height = width == report::FigureWidth::one_column ? 200 : 310;
  grid.panel_right_margin = kColourBar;
  const auto title = report::figure_title(run.problem, grid.size());
  grid.title_height = title.height;
  return report::gnuplot_output_commands(file_stem, grid.size()) + data(y) + data(v) + settings() +
         report::PanelGrid::kLabels + title.command + panel(y, until, grid.panel_box(0, 0)) +
         panel(v, until, grid.panel_box(1, 0)) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
