#include "workflows/study/transient/report_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include "report/figure/figure_layout.hpp"

namespace fpkcheck::study {
namespace {

using fd_fpk::DensitySnapshot;

// Largest numbers of columns and rows of pixels in a heat map, equal to the resolution of the drawn
// figure.
constexpr int kMaxColumns = 400;
constexpr int kPixelRows = 200;

// Interpolates cell averages of a density linearly between the centres of cells.
double interpolate(std::span<const double> edges, std::span<const double> averages, double x) {
  const auto centre = [&](std::size_t b) { return (edges[b] + edges[b + 1]) / 2; };
  std::size_t b = std::upper_bound(edges.begin() + 1, edges.end() - 1, x) - edges.begin() - 1;
  if (x < centre(b) && b > 0) --b;
  if (b + 1 == averages.size()) --b;
  const double weight = std::clamp((x - centre(b)) / (centre(b + 1) - centre(b)), 0.0, 1.0);
  return (1 - weight) * averages[b] + weight * averages[b + 1];
}

MarginalDensityOverTime density_over_time(const TransientRun& run, const std::vector<double>& edges,
                                          std::vector<double> DensitySnapshot::*marginal) {
  MarginalDensityOverTime density{.edges = edges};
  for (const DensitySnapshot& s : run.result.snapshots) {
    density.times.push_back(s.time);
    density.averages.push_back(&(s.*marginal));
  }
  return density;
}

}  // namespace

report::FigurePanel density_heat_map_panel(const MarginalDensityOverTime& density,
                                           const std::string& title, const std::string& symbol) {
  assert(density.times.size() >= 2);
  // Smallest drawn density in a heat map, as a fraction of the largest density.
  constexpr double kVisible = 2e-3;
  const auto& [edges, times, averages] = density;
  double largest = 0, from = edges.back(), to = edges.front();
  for (const auto* p : averages) largest = std::max(largest, std::ranges::max(*p));
  for (const auto* p : averages) {
    for (std::size_t b = 0; b + 1 < edges.size(); ++b) {
      if ((*p)[b] < kVisible * largest) continue;
      from = std::min(from, edges[b]);
      to = std::max(to, edges[b + 1]);
    }
  }
  // If a run has more snapshots than the heat map has columns of pixels, the columns are
  // interpolated in time.
  const int last = static_cast<int>(times.size()) - 1;
  const int steps = std::min(last, kMaxColumns - 1);
  const double until = times.back(), half_step = until / steps / 2;
  report::FigureHeatMap map{
      .x_range = {-half_step, until + half_step},
      .y_range = {from, to},
      .columns = static_cast<std::size_t>(steps + 1),
      .values = {},
      .colour_axis = {fmt::format("{{/:Italic p}}({}, {{/:Italic t}})", symbol), 0, largest},
      .colours = {std::begin(report::kSequentialColours), std::end(report::kSequentialColours)}};
  for (int h = 0; h < kPixelRows; ++h) {
    const double x = from + (to - from) * (h + 0.5) / kPixelRows;
    for (int c = 0; c <= steps; ++c) {
      const double place = static_cast<double>(c) * last / steps;
      const int before = std::min(static_cast<int>(place), last - 1);
      const double weight = place - before;
      map.values.push_back((1 - weight) * interpolate(edges, *averages[before], x) +
                           weight * interpolate(edges, *averages[before + 1], x));
    }
  }
  return {.title = title, .x = {"{/:Italic t}", 0, until}, .y = {symbol, from, to}, .map = map};
}

report::Figure transient_figure(const TransientRun& run) {
  assert(run.result.snapshots.size() >= 2);
  return {.title = report::problem_title_parts(run.problem),
          .panels = {density_heat_map_panel(
                         density_over_time(run, run.result.y_edges, &DensitySnapshot::y),
                         "displacement", "{/:Italic y}"),
                     density_heat_map_panel(
                         density_over_time(run, run.result.v_edges, &DensitySnapshot::v),
                         "velocity", "{/:Italic y}'")},
          .columns = 1};
}

}  // namespace fpkcheck::study
