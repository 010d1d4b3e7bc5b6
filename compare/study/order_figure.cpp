#include <fmt/format.h>

#include <string>
#include <vector>

#include "compare/figure/frame.hpp"
#include "compare/figure/gnuplot.hpp"
#include "compare/study/order.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

// Distinct also in grey print, by their marks: filled where the density may be trusted, else open.
struct Mark {
  const char* colour;
  int filled, open;
};
constexpr Mark kMarks[] = {{"#D55E00", 7, 6},   {"#0072B2", 5, 4},   {"#009E73", 9, 8},
                           {"#CC79A7", 11, 10}, {"#56B4E9", 13, 12}, {"#000000", 15, 14}};

std::vector<std::string> formulations_of(const Json& report) {
  std::vector<std::string> names;
  for (const auto& row : report.at("rows")) {
    const auto name = row.at("formulation").get<std::string>();
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

std::string block_name(std::size_t formulation, bool ok) {
  return fmt::format("{}_{}", ok ? "ok" : "not", formulation);
}

// Rows "order l1_y l1_ydot", those that are ok apart from the others.
std::string distance_blocks(const Json& report) {
  std::string text;
  const auto names = formulations_of(report);
  for (std::size_t f = 0; f < names.size(); ++f) {
    for (const bool ok : {true, false}) {
      text += fmt::format("${} << EOD\n", block_name(f, ok));
      for (const auto& row : report.at("rows")) {
        if (row.at("formulation") != names[f] || is_ok(row) != ok) continue;
        const auto y = number(row, "l1_y"), v = number(row, "l1_ydot");
        if (y && v) text += fmt::format("{} {:.6g} {:.6g}\n", row.at("order").get<int>(), *y, *v);
      }
      text += "EOD\n";
    }
  }
  return text;
}

std::string distance_panel(const Json& report, const char* title, const char* symbol, int column,
                           double left, double right, double top, double bottom) {
  std::string plots;
  const auto names = formulations_of(report);
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Mark& mark = kMarks[f % std::size(kMarks)];
    // A legend even where no order is ok: a point that is off the picture.
    plots += fmt::format(
        "{0}${1} using 1:{2} with linespoints lc rgb '{3}' lw 2 pt {4} ps 1.3 title {5}, "
        "${6} using 1:{2} with points lc rgb '{3}' lw 2 pt {7} ps 1.3 notitle",
        f == 0 ? "" : ", ", block_name(f, true), column, mark.colour, mark.filled,
        gnuplot_literal(names[f]), block_name(f, false), mark.open);
  }
  return fmt::format(
      "set title '{}'\n"
      "set lmargin at screen {:.3f}\nset rmargin at screen {:.3f}\n"
      "set tmargin at screen {:.3f}\nset bmargin at screen {:.3f}\n"
      "set ylabel \"{{/:Italic L}}_1 distance of {{/:Italic p}}({}) to fd-kf\"\n"
      "plot {}\n\n",
      title, left, right, top, bottom, symbol, plots);
}

// Rows with a branch, one block each: fraction and norm of the points, in the branch's order.
struct BranchCurve {
  std::string name;
  std::string block;
};

std::string branch_blocks(const Json& report, std::vector<BranchCurve>& curves) {
  std::string text;
  for (const auto& row : report.at("rows")) {
    if (!row.contains("branch") || !row.at("branch").is_object()) continue;
    BranchCurve curve{fmt::format("{} n = {}", row.at("formulation").get<std::string>(),
                                  row.at("order").get<int>()),
                      fmt::format("branch_{}", curves.size())};
    text += fmt::format("${} << EOD\n", curve.block);
    for (const auto& point : row.at("branch").at("points")) {
      text += fmt::format("{:.6g} {:.6g} {}\n", point.at("fraction").get<double>(),
                          point.at("norm").get<double>(), point.at("fold").get<bool>() ? 1 : 0);
    }
    text += "EOD\n";
    curves.push_back(std::move(curve));
  }
  return text;
}

std::string branch_panel(const std::vector<BranchCurve>& curves) {
  std::string plots;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const Mark& mark = kMarks[k % std::size(kMarks)];
    plots += fmt::format(
        "{0}${1} using 1:2 with lines lc rgb '{2}' lw 2 dt {5} title {3}, "
        "${1} using ($3 == 1 ? $1 : NaN):2 with points lc rgb '{2}' lw 2 pt {4} ps 1.4 notitle",
        k == 0 ? "" : ", ", curves[k].block, mark.colour, gnuplot_literal(curves[k].name),
        mark.open, k / std::size(kMarks) + 1);
  }
  return fmt::format(
      "set title '(c) branches from the exact density without losses; marks: folds'\n"
      "set lmargin at screen 0.09\nset rmargin at screen 0.97\n"
      "set tmargin at screen 0.42\nset bmargin at screen 0.08\n"
      "unset logscale y\nset format y '%g'\nset autoscale\n"
      "set xrange [0:1.02]\nset xtics 0.1\n"
      "set xlabel 'fraction of the way to the full problem'\n"
      "set ylabel 'norm of the coefficients'\n"
      "plot {}\n\n",
      plots);
}

}  // namespace

std::string order_figure(const Json& report, const std::string& file_stem) {
  std::vector<BranchCurve> curves;
  const std::string branches = branch_blocks(report, curves);
  const bool with_branches = !curves.empty();
  int highest = 2;
  for (const auto& row : report.at("rows")) highest = std::max(highest, row.at("order").get<int>());
  const double top = with_branches ? 0.91 : 0.86;
  const double bottom = with_branches ? 0.55 : 0.13;
  return figure_output(file_stem, {.width = 1100, .height = with_branches ? 950 : 560}) +
         distance_blocks(report) + branches +
         fmt::format(
             "set tics out nomirror\nset grid ytics lc rgb '#DDDDDD'\nset key top right\n"
             "set logscale y\nset format y '10^{{%L}}'\n"
             "set xrange [1:{}]\nset xtics 2\nset xlabel 'order {{/:Italic n}}'\n"
             "set multiplot title {} font ',14'\n\n",
             highest + 1, figure_title(report)) +
         distance_panel(report, "(a) displacement", "{/:Italic y}", 2, 0.09, 0.49, top, bottom) +
         distance_panel(report, "(b) velocity; open marks: no admissible density", "{/:Italic y}'",
                        3, 0.57, 0.97, top, bottom) +
         (with_branches ? branch_panel(curves) : "") + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::compare
