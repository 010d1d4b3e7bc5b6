#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/legend_strip.hpp"
#include "report/figure/panel_grid.hpp"
#include "report/figure/text.hpp"
#include "workflows/study/order.hpp"
#include "workflows/study/picture.hpp"

namespace fpkcheck::study {
namespace {

using transform::Variable;

// "order l1_y l1_ydot" for each formulation: the rows that are ok, or the others.
std::vector<Series> formulations_of(const OrderStudy& study, bool ok) {
  return series_of(
      study.rows, ok ? "ok_" : "not_", [](const OrderRow& row) { return row.formulation; },
      [ok](const OrderRow& row) {
        if (!row.l1 || row.solution.is_ok() != ok) return std::string();
        return fmt::format("{} {:.6g} {:.6g}\n", row.order, row.l1->y, row.l1->ydot);
      });
}

std::string with_line(const SeriesLook& look) {
  return fmt::format("with linespoints lc rgb '{}' lw 2 dt {} pt {} ps 1.3", look.colour, look.dash,
                     look.filled);
}

std::string distance_panel(const OrderStudy& study, const char* title, Variable variable,
                           const Place& place) {
  const auto ok = formulations_of(study, true), others = formulations_of(study, false);
  std::string plots;
  for (std::size_t f = 0; f < ok.size(); ++f) {
    const SeriesLook& look = ok[f].look;
    plots += fmt::format(
        "{0}${1} using 1:{2} {3} notitle, ${4} using 1:{2} with points lc rgb '{5}' lw 2 pt {6} ps "
        "1.3 notitle",
        f == 0 ? "" : ", ", ok[f].block, variable == Variable::y ? 2 : 3, with_line(look),
        others[f].block, look.colour, look.open);
  }
  return fmt::format("set title '{}'\n{}set ylabel {}\nplot {}\n\n", title, margins(place),
                     report::gnuplot_text(fmt::format("{{/:Italic L}}_1 distance of {} to {}",
                                                      density_of(variable),
                                                      report::without_marks(study.reference.id()))),
                     plots);
}

// "fraction norm fold" of the rows with a branch, in the order of the branch.
std::vector<Series> branches(const OrderStudy& study) {
  std::vector<OrderRow> rows;
  std::ranges::copy_if(study.rows, std::back_inserter(rows), [](const OrderRow& row) {
    return branch(row.solution.observations).has_value();
  });
  return series_of(
      rows, "branch_",
      [](const OrderRow& row) { return fmt::format("{} n = {}", row.formulation, row.order); },
      [](const OrderRow& row) {
        std::string points;
        const auto followed = branch(row.solution.observations);
        for (const auto& [fraction, norm, fold] : followed->points) {
          points += fmt::format("{:.6g} {:.6g} {}\n", fraction, norm, fold ? 1 : 0);
        }
        return points;
      });
}

std::string with_branch(const SeriesLook& look) {
  return fmt::format("with lines lc rgb '{}' lw 2 dt {}", look.colour, look.dash);
}

std::string branch_panel(const std::vector<Series>& all, char letter, const Place& place) {
  std::string plots;
  for (const auto& one : all) {
    plots += fmt::format(
        "{0}${1} using 1:2 {2} notitle, "
        "${1} using ($3 == 1 ? $1 : NaN):2 with points lc rgb '{3}' lw 2 pt {4} ps 1.4 notitle",
        plots.empty() ? "" : ", ", one.block, with_branch(one.look), one.look.colour,
        one.look.open);
  }
  return fmt::format(
      "set title '({}) branches from the exact density without impact losses'\n{}"
      "unset logscale y\nset format y '%g'\nset autoscale\n"
      "set xrange [0:1.02]\nset xtics 0.1\n"
      "set xlabel 'fraction of the way to the full problem'\n"
      "set ylabel 'norm of the coefficients'\n"
      "plot {}\n\n",
      letter, margins(place), plots);
}

report::Legend legend(const std::vector<Series>& ok, const std::vector<Series>& others,
                      const std::vector<Series>& followed) {
  report::Legend legend{{}, 4};
  for (const auto& one : ok) {
    legend.entries.push_back({fmt::format("NaN {}", with_line(one.look)), one.label});
  }
  const bool any_open =
      std::ranges::any_of(others, [](const Series& one) { return !one.points.empty(); });
  if (any_open) {
    legend.entries.push_back({"NaN with points lc rgb '#444444' lw 2 pt 6 ps 1.3", "open: not ok"});
  }
  for (const auto& one : followed) {
    legend.entries.push_back(
        {fmt::format("NaN {}", with_branch(one.look)), "branch: " + one.label});
  }
  if (!followed.empty()) {
    legend.entries.push_back(
        {"NaN with points lc rgb '#444444' lw 2 pt 6 ps 1.4", "open, on a branch: fold"});
  }
  return legend;
}

}  // namespace

std::string figure(const OrderStudy& study, const std::string& file_stem,
                   report::FigureWidth width) {
  constexpr int kOnScreen = 1100;
  const auto ok = formulations_of(study, true), others = formulations_of(study, false),
             followed = branches(study);
  const bool narrow = width == report::FigureWidth::one_column;
  const report::Legend entries = legend(ok, others, followed);
  report::PanelGrid grid = report::panel_grid(width, kOnScreen);
  grid.columns = narrow ? 1 : 2;
  const int of_orders = narrow ? 2 : 1;  // rows of panels
  grid.rows = of_orders + (followed.empty() ? 0 : 1);
  grid.panel_height = narrow ? 200 : 300;
  grid.legend_height = report::legend_height(entries, grid.width);
  const auto title = report::figure_title(study.problem, grid.size());
  grid.title_height = title.height;

  int highest = 2;
  for (const auto& row : study.rows) highest = std::max(highest, row.order);
  std::string text = report::figure_output(file_stem, grid.size());
  for (const auto& all : {ok, others, followed}) {
    for (const auto& one : all) text += data_block(one.block, one.points);
  }
  text += fmt::format(
      "set tics out nomirror\nset grid ytics lc rgb '#DDDDDD'\nunset key\n{}"
      "set logscale y\nset format y {}\n"
      "set xrange [1:{}]\nset xtics 2\nset xlabel {}\n{}",
      report::PanelGrid::kLabels, report::kPowersOfTen, highest + 1,
      report::gnuplot_text("order {/:Italic n}"), title.command);
  text += distance_panel(study, "(a) displacement", Variable::y, grid.place(std::size_t{0}));
  text += distance_panel(study, "(b) velocity", Variable::ydot, grid.place(std::size_t{1}));
  if (!followed.empty()) {
    Place across = grid.place(of_orders, 0);
    across.right = grid.place(of_orders, grid.columns - 1).right;
    text += branch_panel(followed, 'c', across);
  }
  return text + report::legend_strip(entries, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
