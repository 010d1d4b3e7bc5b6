#include "report/figure/error_source_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "compare/assessment.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

using results::CaseResult;
using results::ErrorSource;
using transform::Moments;

constexpr std::size_t kMaxMaps = 4, kMaxMapsInColumn = 2;
constexpr int kColourBar = 12, kBesideMap = 80;  // width of a colour bar, and with tics, in pixels
// Outer cells with values below this fraction of the largest value are invisible, and are omitted.
constexpr double kVisibleErrorFraction = 1e-3;

struct ErrorMapRow {
  const char* moment;
  const char* symbol;
  double Moments::*member;
};
constexpr ErrorMapRow kRows[] = {{"y2", "E[{/:Italic y}²]", &Moments::y2},
                                 {"v2", "E[{/:Italic y}'²]", &Moments::v2}};

std::vector<std::string> selected_solutions(const CaseResult& case_result,
                                            std::size_t most = kMaxMaps) {
  std::vector<std::string> ids;
  std::set<std::string> formulations;
  const auto add = [&](const transform::Solution& solution) {
    const bool whole = std::ranges::all_of(kRows, [&](const ErrorMapRow& row) {
      return case_result.error_source(solution.id(), row.moment) != nullptr;
    });
    if (whole && ids.size() < most) ids.push_back(solution.id());
  };
  for (const auto* ranked : case_result.assessment.ranked_closures()) {
    const auto& closure = *case_result.find(ranked->id);
    if (ids.size() + 1 < most && formulations.insert(closure.identity.formulation).second)
      add(closure);
  }
  std::ranges::reverse(ids);  // by increasing accuracy from left to right
  for (const auto& solution : case_result.solutions) {
    if (compare::is_solution_of_full_problem(solution)) add(solution);
  }
  return ids;
}

std::string source_block_name(std::size_t column, const ErrorMapRow& row) {
  return fmt::format("${}_{}", row.moment, column);
}

double largest_value(const ErrorSource& source) {
  double most = 0;
  for (const double x : source.density.averages) most = std::max(most, std::abs(x));
  return most;
}

/// The range of the cells that have a visible value in at least one map. The range is symmetric in
/// y', and includes y = 0 if the cells begin at y = 0.
struct VisibleCells {
  std::size_t y_begin = 0, y_end = 1, v_begin = 0, v_end = 0;
};

VisibleCells visible_part(const CaseResult& case_result, const std::vector<std::string>& ids) {
  const auto& cells = case_result.error_source(ids.front(), kRows[0].moment)->density;
  VisibleCells part{.v_begin = cells.nv(), .v_end = 0};
  if (cells.y_edges.front() != 0) part.y_begin = cells.ny() - 1;
  for (const auto& id : ids) {
    for (const ErrorMapRow& row : kRows) {
      const ErrorSource& source = *case_result.error_source(id, row.moment);
      const double least = kVisibleErrorFraction * largest_value(source);
      for (std::size_t i = 0; i < source.density.ny(); ++i) {
        for (std::size_t j = 0; j < source.density.nv(); ++j) {
          if (std::abs(source.density.cell_average(i, j)) <= least) continue;
          part.y_begin = std::min(part.y_begin, i);
          part.y_end = std::max(part.y_end, i + 1);
          part.v_begin = std::min({part.v_begin, j, cells.nv() - 1 - j});
          part.v_end = std::max({part.v_end, j + 1, cells.nv() - j});
        }
      }
    }
  }
  return part;
}

// The colour scale uses the signed square root, so that values remain visible that are small
// relative to the values at the wall.
double signed_root(double value, double limit) {
  return std::copysign(std::sqrt(std::abs(value) / limit), value);
}

double limit_of(const ErrorSource& source) { return std::max(largest_value(source), 1e-300); }

// The data block of a heat map, with a row of cells for each y'.
std::string source_block(const ErrorSource& source, const std::string& name,
                         const VisibleCells& part) {
  std::string text = name + " << EOD\n";
  const double limit = limit_of(source);
  for (std::size_t j = part.v_begin; j < part.v_end; ++j) {
    for (std::size_t i = part.y_begin; i < part.y_end; ++i) {
      text += fmt::format("{:.3g} ", signed_root(source.density.cell_average(i, j), limit));
    }
    text += '\n';
  }
  return text + "EOD\n";
}

// Tics of the colour bar at equal steps of the value. The positions of the tics are signed square
// roots of the values; the tic labels are in units of the power of ten in the axis label.
std::string colour_axis(double limit) {
  constexpr int kMostSteps = 5;  // on either side of 0; then at least two tics are on each side
  const double step = tic_step(0, limit, kMostSteps);
  const auto power = static_cast<int>(std::floor(std::log10(step)));
  std::vector<std::string> tics;
  const int most = static_cast<int>(limit / step * (1 + 1e-9));
  for (int k = -most; k <= most; ++k) {
    const std::string value =
        with_minus_signs(fmt::format("{:.0f}", k * step / std::pow(10, power)));
    tics.push_back(fmt::format("{} {:.4f}", gnuplot_text(value), signed_root(k * step, limit)));
  }
  const std::string unit = power == 0 ? "" : with_minus_signs(fmt::format(", 10^{{{}}}", power));
  return fmt::format("set cblabel {}\nset cbtics ({})\n", gnuplot_text("error per area" + unit),
                     fmt::join(tics, ", "));
}

std::string source_panel(const CaseResult& case_result, const std::string& id, std::size_t column,
                         const ErrorMapRow& moment_row, const VisibleCells& part,
                         const PanelGrid& grid, std::size_t panel) {
  constexpr int kMostTics = 4;  // fit under a map on a screen
  const PanelBox place = grid.panel_box(panel);
  const auto* own = case_result.moment_error_estimate(id);
  const double error = own == nullptr ? 0 : own->error.*moment_row.member;
  const ErrorSource& source = *case_result.error_source(id, moment_row.moment);
  const auto& y = source.density.y_edges;
  const auto& v = source.density.v_edges;
  const double dy = y[1] - y[0], dv = v[1] - v[0];  // uniform cells
  return fmt::format(
      "set title {}\nset ylabel {}\n{}"
      "set xrange [{:.4g}:{:.4g}]\nset xtics {:g}\nset yrange [{:.4g}:{:.4g}]\n{}"
      "set colorbox user origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n"
      "plot {} matrix using ({:.6g}+{:.6g}*$1):({:.6g}+{:.6g}*$2):3 with image notitle\n\n",
      gnuplot_text(fmt::format("({}) {} of {}: {}", static_cast<char>('a' + panel),
                               moment_row.symbol, escape_enhanced_text(id),
                               scientific_text(error))),
      gnuplot_text("{/:Italic y}'"), panel_position_commands(place), y[part.y_begin], y[part.y_end],
      tic_step(y[part.y_begin], y[part.y_end], kMostTics), v[part.v_begin], v[part.v_end],
      colour_axis(limit_of(source)), place.right + 8.0 / grid.width, place.bottom,
      static_cast<double>(kColourBar) / grid.width, place.top - place.bottom,
      source_block_name(column, moment_row), y[part.y_begin] + dy / 2, dy, v[part.v_begin] + dv / 2,
      dv);
}

// On a screen each solution has a column of two maps, but a single solution has a row of two maps.
// On paper each solution has a row of two maps. In a single journal column all maps are below one
// another.
PanelGrid grid_for(std::size_t densities, FigureWidth width) {
  constexpr int kColumnOnScreen = 375, kMoments = static_cast<int>(std::size(kRows));
  const int count = static_cast<int>(densities);
  const int columns = width == FigureWidth::screen        ? std::max(count, kMoments)
                      : width == FigureWidth::two_columns ? kMoments
                                                          : 1;
  PanelGrid grid = panel_grid(width, columns * kColumnOnScreen);
  grid.columns = columns;
  grid.rows = count * kMoments / columns;
  grid.panel_height = width == FigureWidth::screen ? 275 : 190;
  grid.panel_right_margin = kBesideMap;
  return grid;
}

}  // namespace

bool has_error_sources(const CaseResult& case_result) {
  const auto ids = selected_solutions(case_result);
  return std::ranges::any_of(ids, [&](const std::string& id) {
    return std::ranges::any_of(kRows, [&](const ErrorMapRow& row) {
      return largest_value(*case_result.error_source(id, row.moment)) > 0;
    });
  });
}

std::string error_source_script(const CaseResult& case_result, const std::string& file_stem,
                                FigureWidth width) {
  const auto ids = selected_solutions(
      case_result, width == FigureWidth::one_column ? kMaxMapsInColumn : kMaxMaps);
  PanelGrid grid = grid_for(ids.size(), width);
  const FigureTitle title = figure_title(case_result.problem, grid.size());
  grid.title_height = title.height;
  std::string blocks, panels;
  const VisibleCells part = visible_part(case_result, ids);
  for (std::size_t column = 0; column < ids.size(); ++column) {
    for (std::size_t row = 0; row < std::size(kRows); ++row) {
      blocks += source_block(*case_result.error_source(ids[column], kRows[row].moment),
                             source_block_name(column, kRows[row]), part);
      const bool below = width == FigureWidth::screen && ids.size() > 1;
      const std::size_t panel = below ? row * ids.size() + column : column * std::size(kRows) + row;
      panels += source_panel(case_result, ids[column], column, kRows[row], part, grid, panel);
    }
  }
  return gnuplot_output_commands(file_stem, grid.size()) +
         "# A line for each y', from the lowest; values are sign(e) sqrt(|e|/largest)\n" + blocks +
         "\nset palette defined (0 '#053061', 0.2 '#2166ac', 0.4 '#92c5de', 0.5 '#ffffff', "
         "0.6 '#f4a582', 0.8 '#b2182b', 1 '#67001f')\n"
         "set cbrange [-1:1]\nset cbtics font ',10'\nset tics nomirror out\nset border 3\n" +
         PanelGrid::kLabels + fmt::format("set xlabel {}\n", gnuplot_text("{/:Italic y}")) +
         title.command + panels + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
