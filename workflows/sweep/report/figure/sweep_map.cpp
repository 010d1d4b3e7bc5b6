#include "workflows/sweep/report/figure/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "report/figure/gnuplot.hpp"
#include "workflows/sweep/report/figure/key_axis.hpp"

namespace fpkcheck::sweep {
namespace {

using report::FigureSeries;
using transform::Status;

constexpr double kNoDistance = std::numeric_limits<double>::quiet_NaN();
// Smallest L1 distance on the colour scale of the map. L1 distances below kMinColourDistance have
// the colour of kMinColourDistance.
constexpr double kMinColourDistance = 1e-4;

struct ContourLevel {
  double l1;
  const char* name;
  double line_width;
  const char* dash;
};
constexpr ContourLevel kContourLevels[] = {{0.01, "1 %", 2, "solid"}, {0.05, "5 %", 2.6, "(8,5)"}};

/// A mark on the map shows a status other than `ok`, or the reference solution, which has no
/// distance from itself. The marks of statuses differ in shape, so that grey print distinguishes
/// the statuses.
struct SolutionStatusMark {
  const char* symbol;
  std::string name;
  std::optional<Status> status;  ///< status of the marked points; empty for the reference
};

constexpr std::pair<Status, const char*> kStatusSymbols[] = {
    {Status::not_converged, "cross"},  // gnuplot draws the cross as a plus sign
    {Status::ill_posed, "triangle-up-open"},
    {Status::inaccurate, "circle"},
    {Status::inadmissible, "x"},
    {Status::failed, "asterisk"},
    {Status::not_offered, "square-open"}};
static_assert(std::size(kStatusSymbols) + 1 == std::size(transform::kStatusNames));

std::vector<SolutionStatusMark> status_marks() {
  std::vector<SolutionStatusMark> marks;
  for (const auto& [status, symbol] : kStatusSymbols) {
    marks.push_back({symbol, std::string(name(status)), status});
  }
  marks.push_back({"circle-open", "the reference", std::nullopt});
  return marks;
}

/// Map of the results of one method. For the design `product` the map of a method has cells, whose
/// coordinates are the indices of the parameter values. For designs other than `product` the map of
/// a method has discs at the sweep points.
class MethodResultMap {
 public:
  MethodResultMap(const SweepResultsView& view, std::size_t m)
      : view_(view), m_(m), x_(view.sweep_plan(), 0), y_(view.sweep_plan(), 1) {
    if (!has_cells()) return;
    cells_.assign(columns(), std::vector<std::size_t>(rows()));
    for (std::size_t point = 0; point < view.sweep_plan().points.size(); ++point) {
      const auto& values = view.sweep_plan().points[point];
      cells_[x_.map_cell_index(values[0])][y_.map_cell_index(values[1])] = point;
    }
  }

  report::FigurePanel panel(int columns_of_panels) const {
    report::FigurePanel panel{
        .title = report::escape_enhanced_text(view_.sweep_plan().methods[m_].id()),
        .x = has_cells() ? x_.figure_axis_of_cells() : x_.figure_axis(),
        .y = has_cells() ? y_.figure_axis_of_cells() : y_.figure_axis(),
        .map = heat_map(disc_size(columns_of_panels))};
    panel.series.push_back(outline());
    for (const auto& level : kContourLevels) panel.series.push_back(contour(level));
    const int width = 1000 / columns_of_panels;
    for (const auto& mark : status_marks()) {
      panel.series.push_back(marks(mark, tiles(width), tiles(panel_height(columns_of_panels)),
                                   has_cells() ? 0.9 : 0.75 * disc_size(columns_of_panels)));
    }
    return panel;
  }

  static int panel_height(int columns_of_panels) {
    return columns_of_panels <= 2 ? 300 : columns_of_panels == 3 ? 240 : 190;
  }

 private:
  bool has_cells() const { return view_.sweep_plan().design == SweepPlanDesign::product; }
  std::size_t columns() const { return x_.values().size(); }
  std::size_t rows() const { return y_.values().size(); }

  // Returns the number of marks that fit side by side into a length in pixels.
  static std::size_t tiles(int pixels) {
    constexpr int kMarkSpacing = 15;
    return static_cast<std::size_t>(std::max(1, pixels / kMarkSpacing));
  }

  // The size of the map's discs decreases with the number of sweep points, so that discs do not
  // overlap.
  double disc_size(int columns_of_panels) const {
    const auto points = static_cast<double>(view_.sweep_plan().points.size()) * columns_of_panels;
    return std::clamp(36 / std::sqrt(points), 0.5, 1.6);
  }

  // Returns the larger L1 distance of p(y) and p(y'), with a positive lower bound, so that its
  // logarithm is finite.
  double distance(std::size_t point) const {
    const auto l1 = view_.larger_marginal_l1(point, m_);
    return l1 ? std::max(*l1, kMinColourDistance / 10) : kNoDistance;
  }

  // The colours of the map range from light (but not white) to dark, so that grey print preserves
  // the order of the values. Black marks are visible on all colours.
  report::FigureHeatMap heat_map(double disc_size) const {
    report::FigureHeatMap map{
        .x_range = {-0.5, static_cast<double>(columns()) - 0.5},
        .y_range = {-0.5, static_cast<double>(rows()) - 0.5},
        .columns = columns(),
        .values = {},
        .colour_axis = {"larger {/:Italic L}_1 distance", kMinColourDistance, 1, true},
        .colours = {{0, "#FFF0A8"},
                    {0.25, "#FED976"},
                    {0.5, "#FDAE5B"},
                    {0.75, "#F07C3C"},
                    {1, "#CF2A1E"}},
        .no_value_name = "white: no distance",
        .disc_size = disc_size};
    for (std::size_t j = 0; has_cells() && j < rows(); ++j) {
      for (std::size_t i = 0; i < columns(); ++i) map.values.push_back(distance(cells_[i][j]));
    }
    for (std::size_t point = 0; !has_cells() && point < view_.sweep_plan().points.size(); ++point) {
      const auto& values = view_.sweep_plan().points[point];
      map.discs.push_back({x_.coordinate(values[0]), y_.coordinate(values[1]), distance(point)});
    }
    return map;
  }

  // Returns marks of one kind. The map is divided into tiles with at most one mark, since
  // overlapping marks are illegible. A map with few points shows all marks.
  FigureSeries marks(const SolutionStatusMark& mark, std::size_t tiles_across, std::size_t tiles_up,
                     double size) const {
    constexpr std::size_t kFewPoints = 300;
    FigureSeries series{.name = mark.name,
                        .colour = "#000000",
                        .line_width = 1.2,
                        .symbol = mark.symbol,
                        // A large filled mark would hide the colour of the map below the mark.
                        .mark_size = mark.status == Status::inaccurate ? size / 2 : size};
    const bool is_few = !has_cells() && view_.sweep_plan().points.size() <= kFewPoints;
    std::set<std::array<std::size_t, 2>> taken;
    for (const auto& point : view_.results().points) {
      const bool is_marked = mark.status ? point.methods[m_].status == *mark.status
                                         : view_.is_reference(point.point, m_);
      if (!is_marked) continue;
      const auto& values = view_.sweep_plan().points[point.point];
      const std::array tile{tile_index(x_, values[0], tiles_across),
                            tile_index(y_, values[1], tiles_up)};
      if (!is_few && !taken.insert(tile).second) continue;
      series.points.push_back(
          has_cells() ? report::FigurePoint{static_cast<double>(x_.map_cell_index(values[0])),
                                            static_cast<double>(y_.map_cell_index(values[1]))}
                      : report::FigurePoint{x_.coordinate(values[0]), y_.coordinate(values[1])});
    }
    return series;
  }

  static std::size_t tile_index(const SweepParameterAxis& axis, const base::Value& value,
                                std::size_t tiles) {
    const auto count = static_cast<double>(tiles);
    return static_cast<std::size_t>(
        std::min(axis.relative_figure_coordinate(value) * count, count - 1));
  }

  static void add_segment(FigureSeries& series, const std::array<double, 2>& from,
                          const std::array<double, 2>& to) {
    series.points.push_back({from[0], from[1]});
    series.points.push_back({to[0], to[1]});
    series.points.push_back({to[0], kNoDistance});
  }

  // Returns the border lines between map cells with status `ok` and cells with another status.
  FigureSeries outline() const {
    FigureSeries series{
        .name = "outline: not ok", .colour = "#000000", .dash = "solid", .line_width = 0.8};
    if (!has_cells()) return series;
    const auto not_ok = [&](std::size_t i, std::size_t j) {
      const auto* result = view_.method_result(cells_[i][j], m_);
      return result != nullptr && result->status != Status::ok;
    };
    for (std::size_t i = 0; i < columns(); ++i) {
      for (std::size_t j = 0; j < rows(); ++j) {
        const double x = static_cast<double>(i), y = static_cast<double>(j);
        if (i + 1 < columns() && not_ok(i, j) != not_ok(i + 1, j)) {
          add_segment(series, {x + 0.5, y - 0.5}, {x + 0.5, y + 0.5});
        }
        if (j + 1 < rows() && not_ok(i, j) != not_ok(i, j + 1)) {
          add_segment(series, {x - 0.5, y + 0.5}, {x + 0.5, y + 0.5});
        }
      }
    }
    return series;
  }

  // Returns a contour by marching squares. The logarithms of the L1 distances are interpolated
  // linearly along the edges of squares of four neighbouring cells.
  FigureSeries contour(const ContourLevel& level) const {
    FigureSeries series{.name = level.name,
                        .colour = "#08306B",
                        .dash = level.dash,
                        .line_width = level.line_width};
    if (!has_cells() || x_.is_categorical() || y_.is_categorical()) return series;
    constexpr std::array<std::array<std::size_t, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (std::size_t i = 0; i + 1 < columns(); ++i) {
      for (std::size_t j = 0; j + 1 < rows(); ++j) {
        std::array<double, 4> above;  // logarithm of the ratio of distance and contour level
        for (std::size_t k = 0; k < above.size(); ++k) {
          above[k] =
              std::log10(distance(cells_[i + kCorners[k][0]][j + kCorners[k][1]]) / level.l1);
        }
        std::vector<std::array<double, 2>> crossings;
        for (std::size_t k = 0; k < above.size(); ++k) {
          const double from = above[k], to = above[(k + 1) % 4];
          if (!std::isfinite(from) || !std::isfinite(to) || (from < 0) == (to < 0)) continue;
          const double part = from / (from - to);
          const auto coordinate = [&](std::size_t axis, std::size_t origin) {
            return static_cast<double>(origin + kCorners[k][axis]) +
                   part * (static_cast<double>(kCorners[(k + 1) % 4][axis]) -
                           static_cast<double>(kCorners[k][axis]));
          };
          crossings.push_back({coordinate(0, i), coordinate(1, j)});
        }
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
          add_segment(series, crossings[k], crossings[k + 1]);
        }
      }
    }
    return series;
  }

  const SweepResultsView& view_;
  std::size_t m_;
  SweepParameterAxis x_, y_;
  std::vector<std::vector<std::size_t>> cells_;  // number of the point in each cell, by x and y
};

}  // namespace

report::Figure distance_map_figure(const SweepResultsView& view) {
  const auto methods = view.compared_method_indices();
  const int count = static_cast<int>(methods.size());
  const int columns = count <= 3 ? count : count == 4 ? 2 : count <= 6 ? 3 : 4;
  report::Figure figure{.title = view.figure_title_parts(),
                        .columns = columns,
                        .screen_width = 1200,
                        .panel_height = MethodResultMap::panel_height(columns)};
  for (const std::size_t m : methods)
    figure.panels.push_back(MethodResultMap(view, m).panel(columns));
  return figure;
}

}  // namespace fpkcheck::sweep
