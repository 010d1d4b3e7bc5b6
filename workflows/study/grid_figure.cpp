#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "methods/plot_style.hpp"
#include "report/figure/frame.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/text.hpp"
#include "workflows/study/grid.hpp"
#include "workflows/study/plot_series.hpp"

namespace fpkcheck::study {
namespace {

using transform::Variable;

template <class Row>
bool is_drawn(const Row& row) {
  return row.solution.is_ok() && row.l1;
}

// A row of a data block: "cells-per-deviation milliseconds l1_y l1_ydot".
template <class Row>
std::string point(const Row& row, double fineness) {
  if (!is_drawn(row)) return "";
  return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", fineness, row.solution.seconds * 1000,
                     row.l1->y, row.l1->ydot);
}

std::vector<PlotSeries> grids(const GridStudy& study) {
  auto all = make_series(
      study.rows, "grid_",
      [](const GridRow& row) { return fmt::format("finite volumes, order {}", row.order); },
      [](const GridRow& row) { return point(row, row.refinement); });
  std::vector<transform::SolutionIdentity> schemes;
  for (std::size_t k = 0; k < all.size(); ++k) {
    schemes.push_back({.id = all[k].label, .method = "fd", .plot_style = methods::scheme_style(k)});
  }
  const auto looks = series_styles(schemes);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].plot_style = looks[k];
  return all;
}

std::string method_label(const ComparedMethodRow& row) {
  const auto& identity = row.solution.identity;
  if (identity.role == transform::SolutionRole::simulation) return "simulation";
  return fmt::format("closure, {}{}",
                     identity.formulation.empty() ? identity.family : identity.formulation,
                     identity.order ? ", n = 2, 4, .." : "");
}

constexpr const char* kSlopeStyle = "with lines dt (6,6) lc rgb '#AAAAAA'";

std::string line_style(const SeriesStyle& plot_style) {
  return fmt::format("with linespoints lc rgb '{}' lw 2 dt {} pt {} ps 1.2", plot_style.colour,
                     plot_style.dash, plot_style.filled);
}

// Dashed lines with the slope of each scheme's nominal order, through the first point of the
// scheme.
std::string order_slopes(const GridStudy& study, double MarginalL1Distances::*variable) {
  std::string text;
  std::set<int> drawn;
  for (const auto& row : study.rows) {
    if (!is_drawn(row) || !drawn.insert(row.order).second) continue;
    text += fmt::format(", {:.6g}*(x/{:.6g})**(-{}) {} notitle", (*row.l1).*variable,
                        row.refinement, row.order, kSlopeStyle);
  }
  return text;
}

/// The column of the data blocks that is the abscissa of a panel.
enum Abscissa { by_fineness = 1, by_time = 2 };

std::string panel(const std::vector<PlotSeries>& all, const std::string& title, Variable variable,
                  Abscissa abscissa, const PanelBox& place, const std::string& beside = "") {
  std::string plots;
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    plots += fmt::format("{}${} using {}:{} {} notitle", plots.empty() ? "" : ", ", series.block,
                         static_cast<int>(abscissa), variable == Variable::y ? 3 : 4,
                         line_style(series.plot_style));
  }
  if (plots.empty()) return "";
  return fmt::format("set title '{}'\n{}set ylabel {}\nplot {}\n\n", title,
                     panel_position_commands(place),
                     report::gnuplot_text(fmt::format(
                         "{{/:Italic L}}_1 distance of {} to the limit", density_symbol(variable))),
                     plots + beside);
}

// Axis ranges with a margin for the tick marks. The ranges contain the points, but not necessarily
// the dashed lines.
std::string axis_ranges(const GridStudy& study) {
  double least = 1, most = 1e-9;
  for (const auto& row : study.rows) {
    if (!is_drawn(row)) continue;
    for (const double l1 : {row.l1->y, row.l1->ydot}) {
      if (l1 > 0) least = std::min(least, l1);
      most = std::max(most, l1);
    }
  }
  return fmt::format("set xrange [{:.4g}:{:.4g}]\nset yrange [{:.4g}:{:.4g}]\n",
                     study.rows.front().refinement / 1.15, study.rows.back().refinement * 1.15,
                     least / 2, most * 2);
}

report::Legend legend(const std::vector<PlotSeries>& all) {
  report::Legend legend{{}, 4};
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    legend.entries.push_back({fmt::format("NaN {}", line_style(series.plot_style)), series.label});
  }
  legend.entries.push_back({fmt::format("NaN {}", kSlopeStyle), "slope of the scheme's order"});
  return legend;
}

}  // namespace

std::string figure(const GridStudy& study, const std::string& file_stem,
                   report::FigureWidth width) {
  constexpr int kScreenWidth = 1300;
  const auto fd = grids(study);
  auto all = fd;
  for (auto& series : make_series(study.others, "other_", method_label,
                                  [](const ComparedMethodRow& row) { return point(row, 0); })) {
    all.push_back(std::move(series));
  }
  if (std::ranges::all_of(all, &std::string::empty, &PlotSeries::points)) return "";
  const report::Legend entries = legend(all);
  const bool narrow = width == report::FigureWidth::one_column;
  report::PanelGrid grid = report::panel_grid(width, kScreenWidth);
  grid.columns = narrow ? 1 : 2;
  grid.rows = 4 / grid.columns;
  grid.panel_height = narrow ? 180 : 285;
  grid.legend_height = report::legend_height(entries, grid.width);
  const auto title = report::figure_title(study.problem, grid.size());
  grid.title_height = title.height;
  const auto place = [&](std::size_t panel) { return grid.panel_box(panel); };

  std::string text = report::gnuplot_output_commands(file_stem, grid.size());
  for (const auto& series : all) text += data_block(series.block, series.points);
  text += fmt::format(
      "set tics out nomirror\nset border 3\nset grid lc rgb '#DDDDDD' lt 1 dt solid lw 0.6\n"
      "unset key\n{}set logscale xy\nset format y {}\n{}",
      report::PanelGrid::kLabels, report::kPowerOfTenFormat, title.command);
  text += fmt::format(
      "set xlabel 'cells per direction, relative to the automatic grid'\nset format x '%g'\n"
      "{}set xtics ({})\n",
      axis_ranges(study), "0.125, 0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4, 5.66, 8");
  text += panel(fd, "(a) grids: displacement", Variable::y, by_fineness, place(0),
                order_slopes(study, &MarginalL1Distances::y));
  text += panel(fd, "(b) grids: velocity", Variable::ydot, by_fineness, place(1),
                order_slopes(study, &MarginalL1Distances::ydot));
  text += "set autoscale\n";
  text +=
      "set xlabel 'wall-clock time of one solve, ms'\nset xtics autofreq\n"
      "set format x '%g'\n";
  text += panel(all, "(c) error against cost: displacement", Variable::y, by_time, place(2));
  text += panel(all, "(d) error against cost: velocity", Variable::ydot, by_time, place(3));
  return text + report::legend_strip_commands(entries, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
