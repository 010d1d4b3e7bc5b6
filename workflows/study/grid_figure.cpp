#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "methods/look.hpp"
#include "report/figure/frame.hpp"
#include "report/figure/legend_strip.hpp"
#include "report/figure/panel_grid.hpp"
#include "report/figure/text.hpp"
#include "workflows/study/grid.hpp"
#include "workflows/study/picture.hpp"

namespace fpkcheck::study {
namespace {

using transform::Variable;

template <class Row>
bool is_drawn(const Row& row) {
  return row.solution.is_ok() && row.l1;
}

// "cells-per-deviation milliseconds l1_y l1_ydot"
template <class Row>
std::string point(const Row& row, double fineness) {
  if (!is_drawn(row)) return "";
  return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", fineness, row.solution.seconds * 1000,
                     row.l1->y, row.l1->ydot);
}

std::vector<Series> grids(const GridStudy& study) {
  auto all = series_of(
      study.rows, "grid_",
      [](const GridRow& row) { return fmt::format("finite volumes, order {}", row.order); },
      [](const GridRow& row) { return point(row, row.refinement); });
  std::vector<transform::Identity> schemes;
  for (std::size_t k = 0; k < all.size(); ++k) {
    schemes.push_back({.id = all[k].label, .method = "fd", .look = methods::scheme_look(k)});
  }
  const auto looks = series_looks(schemes);
  for (std::size_t k = 0; k < all.size(); ++k) all[k].look = looks[k];
  return all;
}

std::string label_of(const OtherRow& row) {
  const auto& who = row.solution.identity;
  if (who.role == transform::Role::simulation) return "simulation";
  return fmt::format("closure, {}{}", who.formulation.empty() ? who.family : who.formulation,
                     who.order ? ", n = 2, 4, .." : "");
}

constexpr const char* kSlope = "with lines dt (6,6) lc rgb '#AAAAAA'";

std::string drawn_with(const SeriesLook& look) {
  return fmt::format("with linespoints lc rgb '{}' lw 2 dt {} pt {} ps 1.2", look.colour, look.dash,
                     look.filled);
}

// Reference slope of each scheme's order, dashed, through its first point.
std::string slopes(const GridStudy& study, double MarginalL1::*variable) {
  std::string text;
  std::set<int> drawn;
  for (const auto& row : study.rows) {
    if (!is_drawn(row) || !drawn.insert(row.order).second) continue;
    text += fmt::format(", {:.6g}*(x/{:.6g})**(-{}) {} notitle", (*row.l1).*variable,
                        row.refinement, row.order, kSlope);
  }
  return text;
}

/// Column of the data that is the abscissa.
enum Abscissa { by_fineness = 1, by_time = 2 };

std::string panel(const std::vector<Series>& all, const std::string& title, Variable variable,
                  Abscissa abscissa, const Place& place, const std::string& beside = "") {
  std::string plots;
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    plots += fmt::format("{}${} using {}:{} {} notitle", plots.empty() ? "" : ", ", series.block,
                         static_cast<int>(abscissa), variable == Variable::y ? 3 : 4,
                         drawn_with(series.look));
  }
  if (plots.empty()) return "";
  return fmt::format("set title '{}'\n{}set ylabel {}\nplot {}\n\n", title, margins(place),
                     report::gnuplot_text(fmt::format(
                         "{{/:Italic L}}_1 distance of {} to the limit", density_of(variable))),
                     plots + beside);
}

// Ranges with a margin for the tick marks. Only the points count, not the dashed lines of slope.
std::string ranges_of_grids(const GridStudy& study) {
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

report::Legend legend(const std::vector<Series>& all) {
  report::Legend legend{{}, 4};
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    legend.entries.push_back({fmt::format("NaN {}", drawn_with(series.look)), series.label});
  }
  legend.entries.push_back({fmt::format("NaN {}", kSlope), "slope of the scheme's order"});
  return legend;
}

}  // namespace

std::string figure(const GridStudy& study, const std::string& file_stem,
                   report::FigureWidth width) {
  constexpr int kOnScreen = 1300;
  const auto fd = grids(study);
  auto all = fd;
  for (auto& series : series_of(study.others, "other_", label_of,
                                [](const OtherRow& row) { return point(row, 0); })) {
    all.push_back(std::move(series));
  }
  if (std::ranges::all_of(all, &std::string::empty, &Series::points)) return "";
  const report::Legend entries = legend(all);
  const bool narrow = width == report::FigureWidth::one_column;
  report::PanelGrid grid = report::panel_grid(width, kOnScreen);
  grid.columns = narrow ? 1 : 2;
  grid.rows = 4 / grid.columns;
  grid.panel_height = narrow ? 180 : 285;
  grid.legend_height = report::legend_height(entries, grid.width);
  const auto title = report::figure_title(study.problem, grid.size());
  grid.title_height = title.height;
  const auto place = [&](std::size_t panel) { return grid.place(panel); };

  std::string text = report::figure_output(file_stem, grid.size());
  for (const auto& series : all) text += data_block(series.block, series.points);
  text += fmt::format(
      "set tics out nomirror\nset border 3\nset grid lc rgb '#DDDDDD' lt 1 dt solid lw 0.6\n"
      "unset key\n{}set logscale xy\nset format y {}\n{}",
      report::PanelGrid::kLabels, report::kPowersOfTen, title.command);
  text += fmt::format(
      "set xlabel 'cells per direction, relative to the automatic grid'\nset format x '%g'\n"
      "{}set xtics ({})\n",
      ranges_of_grids(study), "0.125, 0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4, 5.66, 8");
  text += panel(fd, "(a) grids: displacement", Variable::y, by_fineness, place(0),
                slopes(study, &MarginalL1::y));
  text += panel(fd, "(b) grids: velocity", Variable::ydot, by_fineness, place(1),
                slopes(study, &MarginalL1::ydot));
  text += "set autoscale\n";
  text +=
      "set xlabel 'wall-clock time of one solve, ms'\nset xtics autofreq\n"
      "set format x '%g'\n";
  text += panel(all, "(c) error against cost: displacement", Variable::y, by_time, place(2));
  text += panel(all, "(d) error against cost: velocity", Variable::ydot, by_time, place(3));
  return text + report::legend_strip(entries, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
