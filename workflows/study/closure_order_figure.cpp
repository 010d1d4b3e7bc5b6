#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/text.hpp"
#include "workflows/study/closure_order.hpp"
#include "workflows/study/plot_series.hpp"

namespace fpkcheck::study {
namespace {

using transform::Variable;

// The data blocks of each formulation with the columns "order l1_y l1_ydot": the rows that are ok,
// or the rows that are not ok.
std::vector<PlotSeries> formulation_series(const ClosureOrderStudy& study, bool ok) {
  return make_series(
      study.rows, ok ? "ok_" : "not_", [](const ClosureOrderRow& row) { return row.formulation; },
      [ok](const ClosureOrderRow& row) {
        if (!row.l1 || row.solution.is_ok() != ok) return std::string();
        return fmt::format("{} {:.6g} {:.6g}\n", row.order, row.l1->y, row.l1->ydot);
      });
}

std::string line_style(const SeriesStyle& plot_style) {
  return fmt::format("with linespoints lc rgb '{}' lw 2 dt {} pt {} ps 1.3", plot_style.colour,
                     plot_style.dash, plot_style.filled);
}

std::string distance_panel(const ClosureOrderStudy& study, const char* title, Variable variable,
                           const PanelBox& place) {
  const auto ok = formulation_series(study, true), others = formulation_series(study, false);
  std::string plots;
  for (std::size_t f = 0; f < ok.size(); ++f) {
    const SeriesStyle& plot_style = ok[f].plot_style;
    plots += fmt::format(
        "{0}${1} using 1:{2} {3} notitle, ${4} using 1:{2} with points lc rgb '{5}' lw 2 pt {6} ps "
        "1.3 notitle",
        f == 0 ? "" : ", ", ok[f].block, variable == Variable::y ? 2 : 3, line_style(plot_style),
        others[f].block, plot_style.colour, plot_style.open);
  }
  return fmt::format("set title '{}'\n{}set ylabel {}\nplot {}\n\n", title,
                     panel_position_commands(place),
                     report::gnuplot_text(fmt::format(
                         "{{/:Italic L}}_1 distance of {} to {}", density_symbol(variable),
                         report::escape_enhanced_text(study.reference.id()))),
                     plots);
}

// The data blocks of the closures with a branch. The columns are "fraction norm fold"; the rows
// have the order of the points on the branch.
std::vector<PlotSeries> branches(const ClosureOrderStudy& study) {
  std::vector<ClosureOrderRow> rows;
  std::ranges::copy_if(study.rows, std::back_inserter(rows), [](const ClosureOrderRow& row) {
    return solution_branch(row.solution.metrics).has_value();
  });
  return make_series(
      rows, "branch_",
      [](const ClosureOrderRow& row) {
        return fmt::format("{} n = {}", row.formulation, row.order);
      },
      [](const ClosureOrderRow& row) {
        std::string points;
        const auto followed = solution_branch(row.solution.metrics);
        for (const auto& [fraction, norm, fold] : followed->points) {
          points += fmt::format("{:.6g} {:.6g} {}\n", fraction, norm, fold ? 1 : 0);
        }
        return points;
      });
}

std::string branch_style(const SeriesStyle& plot_style) {
  return fmt::format("with lines lc rgb '{}' lw 2 dt {}", plot_style.colour, plot_style.dash);
}

std::string branch_panel(const std::vector<PlotSeries>& all, char letter, const PanelBox& place) {
  std::string plots;
  for (const auto& one : all) {
    plots += fmt::format(
        "{0}${1} using 1:2 {2} notitle, "
        "${1} using ($3 == 1 ? $1 : NaN):2 with points lc rgb '{3}' lw 2 pt {4} ps 1.4 notitle",
        plots.empty() ? "" : ", ", one.block, branch_style(one.plot_style), one.plot_style.colour,
        one.plot_style.open);
  }
  return fmt::format(
      "set title '({}) branches from the exact density without impact losses'\n{}"
      "unset logscale y\nset format y '%g'\nset autoscale\n"
      "set xrange [0:1.02]\nset xtics 0.1\n"
      "set xlabel 'fraction of the way to the full problem'\n"
      "set ylabel 'norm of the coefficients'\n"
      "plot {}\n\n",
      letter, panel_position_commands(place), plots);
}

report::Legend legend(const std::vector<PlotSeries>& ok, const std::vector<PlotSeries>& others,
                      const std::vector<PlotSeries>& followed) {
  report::Legend legend{{}, 4};
  for (const auto& one : ok) {
    legend.entries.push_back({fmt::format("NaN {}", line_style(one.plot_style)), one.label});
  }
  const bool any_open =
      std::ranges::any_of(others, [](const PlotSeries& one) { return !one.points.empty(); });
  if (any_open) {
    legend.entries.push_back({"NaN with points lc rgb '#444444' lw 2 pt 6 ps 1.3", "open: not ok"});
  }
  for (const auto& one : followed) {
    legend.entries.push_back(
        {fmt::format("NaN {}", branch_style(one.plot_style)), "branch: " + one.label});
  }
  if (!followed.empty()) {
    legend.entries.push_back(
        {"NaN with points lc rgb '#444444' lw 2 pt 6 ps 1.4", "open, on a branch: fold"});
  }
  return legend;
}

}  // namespace

std::string figure(const ClosureOrderStudy& study, const std::string& file_stem,
                   report::FigureWidth width) {
  constexpr int kScreenWidth = 1100;
  const auto ok = formulation_series(study, true), others = formulation_series(study, false),
             followed = branches(study);
  const bool narrow = width == report::FigureWidth::one_column;
  const report::Legend entries = legend(ok, others, followed);
  report::PanelGrid grid = report::panel_grid(width, kScreenWidth);
  grid.columns = narrow ? 1 : 2;
  const int order_rows = narrow ? 2 : 1;  // rows of panels
  grid.rows = order_rows + (followed.empty() ? 0 : 1);
  grid.panel_height = narrow ? 200 : 300;
  grid.legend_height = report::legend_height(entries, grid.width);
  const auto title = report::figure_title(study.problem, grid.size());
  grid.title_height = title.height;

  int highest = 2;
  for (const auto& row : study.rows) highest = std::max(highest, row.order);
  std::string text = report::gnuplot_output_commands(file_stem, grid.size());
  for (const auto& all : {ok, others, followed}) {
    for (const auto& one : all) text += data_block(one.block, one.points);
  }
  text += fmt::format(
      "set tics out nomirror\nset grid ytics lc rgb '#DDDDDD'\nunset key\n{}"
      "set logscale y\nset format y {}\n"
      "set xrange [1:{}]\nset xtics 2\nset xlabel {}\n{}",
      report::PanelGrid::kLabels, report::kPowerOfTenFormat, highest + 1,
      report::gnuplot_text("order {/:Italic n}"), title.command);
  text += distance_panel(study, "(a) displacement", Variable::y, grid.panel_box(std::size_t{0}));
  text += distance_panel(study, "(b) velocity", Variable::ydot, grid.panel_box(std::size_t{1}));
  if (!followed.empty()) {
    PanelBox across = grid.panel_box(order_rows, 0);
    across.right = grid.panel_box(order_rows, grid.columns - 1).right;
    text += branch_panel(followed, 'c', across);
  }
  return text + report::legend_strip_commands(entries, grid.size()) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
