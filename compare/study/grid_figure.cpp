#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "compare/figure/frame.hpp"
#include "compare/figure/gnuplot.hpp"
#include "compare/study/grid.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

/// A line of the picture: points by increasing fineness.
struct Series {
  std::string block;
  std::string label;
  const char* colour;
  int mark;
  std::string points;  ///< rows "cells-per-deviation milliseconds l1_y l1_ydot"
};

// Colours and marks that stay apart in grey print too.
struct Look {
  const char* colour;
  int mark;
};
constexpr Look kGrids[] = {{"#9ECAE1", 7}, {"#4292C6", 5}, {"#08519C", 9}, {"#08306B", 13}};
constexpr Look kSimulation{"#000000", 3};

Look look_of_formulation(const std::string& formulation) {
  if (formulation.starts_with("moment")) return {"#CC79A7", 11};
  if (formulation.starts_with("polar")) return {"#87811F", 15};
  return {"#D55E00", 4};
}

std::string point(const Json& row, double fineness) {
  const auto y = number(row, "l1_y"), v = number(row, "l1_ydot"), s = number(row, "seconds");
  if (!is_ok(row) || !y || !v || !s) return "";
  return fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", fineness, *s * 1000, *y, *v);
}

std::vector<Series> grids(const Json& report) {
  std::vector<Series> all;
  for (const auto& row : report.at("rows")) {
    const int order = row.at("order").get<int>();
    const std::string label = fmt::format("finite differences, order {}", order);
    if (all.empty() || all.back().label != label) {
      const Look& look = kGrids[all.size() % std::size(kGrids)];
      all.push_back({fmt::format("grid_{}", order), label, look.colour, look.mark, ""});
    }
    all.back().points += point(row, row.at("refinement").get<double>());
  }
  return all;
}

std::vector<Series> others(const Json& report) {
  std::vector<Series> all;
  for (const auto& row : report.at("others")) {
    const bool simulated = row.at("method") == "mcs";
    const std::string label =
        simulated ? std::string("simulation")
                  : "closure, " + row.at("formulation").get<std::string>() + ", n = 2, 4, ..";
    if (all.empty() || all.back().label != label) {
      const Look look =
          simulated ? kSimulation : look_of_formulation(row.at("formulation").get<std::string>());
      all.push_back({fmt::format("other_{}", all.size()), label, look.colour, look.mark, ""});
    }
    all.back().points += point(row, 0);
  }
  return all;
}

std::string block(const Series& series) {
  return fmt::format("${} << EOD\n{}EOD\n", series.block, series.points);
}

std::string panel(const std::vector<Series>& all, const char* title, const char* symbol, int x,
                  int y, double left, double right, double top, double bottom,
                  const std::string& beside = "") {
  std::string plots;
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    plots += fmt::format("{}${} using {}:{} with linespoints lc rgb '{}' lw 2 pt {} ps 1.2 notitle",
                         plots.empty() ? "" : ", ", series.block, x, y, series.colour, series.mark);
  }
  if (plots.empty()) return "";
  return fmt::format(
      "set title '{}'\n"
      "set lmargin at screen {:.3f}\nset rmargin at screen {:.3f}\n"
      "set tmargin at screen {:.3f}\nset bmargin at screen {:.3f}\n"
      "set ylabel \"{{/:Italic L}}_1 distance of {{/:Italic p}}({}) to the limit\"\n"
      "plot {}\n\n",
      title, left, right, top, bottom, symbol, plots + beside);
}

// What the order of each scheme looks like, dashed, from its first point.
std::string slopes(const Json& report, const char* distance) {
  std::string text;
  std::set<int> drawn;
  for (const auto& row : report.at("rows")) {
    const int order = row.at("order").get<int>();
    const auto l1 = number(row, distance);
    if (!is_ok(row) || !l1 || !drawn.insert(order).second) continue;
    text += fmt::format(", {:.6g}*(x/{:.6g})**(-{}) with lines dt (6,6) lc rgb '#AAAAAA' notitle",
                        *l1, row.at("refinement").get<double>(), order);
  }
  return text;
}

// From the smallest distance to the largest, so that the dashed lines do not stretch it.
std::string distance_range(const Json& report) {
  double least = 1, most = 1e-9;
  for (const auto& row : report.at("rows")) {
    for (const char* key : {"l1_y", "l1_ydot"}) {
      const auto l1 = number(row, key);
      if (!is_ok(row) || !l1 || *l1 <= 0) continue;
      least = std::min(least, *l1);
      most = std::max(most, *l1);
    }
  }
  return fmt::format("set yrange [{:.4g}:{:.4g}]\n", least / 2, most * 2);
}

// Smallest and largest refinement, with room for the marks.
std::string refinement_range(const Json& report) {
  double least = 1e9, most = 0;
  for (const auto& row : report.at("rows")) {
    const double refinement = row.at("refinement").get<double>();
    least = std::min(least, refinement);
    most = std::max(most, refinement);
  }
  return fmt::format("set xrange [{:.4g}:{:.4g}]\n", least / 1.15, most * 1.15);
}

std::string legend(const std::vector<Series>& all) {
  std::string plots;
  for (const auto& series : all) {
    if (series.points.empty()) continue;
    plots += fmt::format("{}NaN with linespoints lc rgb '{}' lw 2 pt {} ps 1.2 title {}",
                         plots.empty() ? "" : ", ", series.colour, series.mark,
                         gnuplot_literal(series.label));
  }
  return fmt::format(
      "unset title\nunset xlabel\nunset ylabel\nunset border\nunset tics\nunset grid\n"
      "unset logscale\n"
      "set lmargin at screen 0.02\nset rmargin at screen 0.98\n"
      "set tmargin at screen 0.11\nset bmargin at screen 0.005\n"
      "set key center center horizontal maxcols 4 Left reverse samplen 3 spacing 1.2\n"
      "plot [0:1] [0:1] {}\n",
      plots);
}

}  // namespace

std::string grid_figure(const Json& report, const std::string& file_stem) {
  const auto fd = grids(report);
  auto all = fd;
  for (auto& series : others(report)) all.push_back(std::move(series));
  if (std::ranges::all_of(all, [](const Series& series) { return series.points.empty(); })) {
    return "";
  }
  std::string text = figure_output(file_stem, {.width = 1300, .height = 950});
  for (const auto& series : all) text += block(series);
  text += fmt::format(
      "set tics out nomirror\nset border 3\nset grid lc rgb '#DDDDDD' lt 1 dt solid lw 0.6\n"
      "set logscale xy\nset format y '10^{{%L}}'\n"
      "set multiplot title {} font ',14'\n\n",
      figure_title(report));
  text += "set xlabel 'cells in a direction, relative to the automatic grid'\nset format x '%g'\n" +
          refinement_range(report) + distance_range(report) +
          "set xtics (0.125, 0.25, 0.35, 0.5, 0.71, 1, 1.41, 2, 2.83, 4, 5.66, 8)\n";
  constexpr double kLeft[] = {0.075, 0.565}, kRight[] = {0.485, 0.975};
  text += panel(fd, "(a) grids: displacement; dashed: the order of the scheme", "{/:Italic y}", 1,
                3, kLeft[0], kRight[0], 0.91, 0.61, slopes(report, "l1_y"));
  text += panel(fd, "(b) grids: velocity", "{/:Italic y}'", 1, 4, kLeft[1], kRight[1], 0.91, 0.61,
                slopes(report, "l1_ydot"));
  text += "set autoscale\n";
  text += "set xlabel 'wall-clock time of one solve, ms'\nset xtics autofreq\nset format x '%g'\n";
  text += panel(all, "(c) error against cost: displacement", "{/:Italic y}", 2, 3, kLeft[0],
                kRight[0], 0.50, 0.19);
  text += panel(all, "(d) error against cost: velocity", "{/:Italic y}'", 2, 4, kLeft[1], kRight[1],
                0.50, 0.19);
  return text + legend(all) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::compare
