#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "study/order.hpp"
#include "study/picture.hpp"

namespace fpkcheck::study {
namespace {

using transform::Variable;

// "order l1_y l1_ydot" of the rows of each formulation that are ok, or of the others.
std::vector<Series> formulations_of(const OrderStudy& study, bool ok) {
  return series_of(
      study.rows, ok ? "ok_" : "not_", [](const OrderRow& row) { return row.formulation; },
      [ok](const OrderRow& row) {
        if (!row.l1 || row.solution.is_ok() != ok) return std::string();
        return fmt::format("{} {:.6g} {:.6g}\n", row.order, row.l1->y, row.l1->ydot);
      });
}

std::string distance_panel(const OrderStudy& study, const char* title, Variable variable,
                           const Place& place) {
  const auto ok = formulations_of(study, true), others = formulations_of(study, false);
  std::string plots;
  for (std::size_t f = 0; f < ok.size(); ++f) {
    const SeriesLook& look = ok[f].look;
    // A legend even where no order is ok: a point that is off the picture.
    plots += fmt::format(
        "{0}${1} using 1:{2} with linespoints lc rgb '{3}' lw 2 dt {4} pt {5} ps 1.3 title {6}, "
        "${7} using 1:{2} with points lc rgb '{3}' lw 2 pt {8} ps 1.3 notitle",
        f == 0 ? "" : ", ", ok[f].block, variable == Variable::y ? 2 : 3, look.colour, look.dash,
        look.filled, report::gnuplot_literal(ok[f].label), others[f].block, look.open);
  }
  return fmt::format(
      "set title '{}'\n{}set ylabel \"{{/:Italic L}}_1 distance of {} to \".{}\nplot {}\n\n", title,
      margins(place), density_of(variable), report::gnuplot_literal(study.reference.id()), plots);
}

// "fraction norm fold" of the rows that followed a branch, in the branch's order.
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

std::string branch_panel(const std::vector<Series>& all) {
  std::string plots;
  for (const auto& one : all) {
    plots += fmt::format(
        "{0}${1} using 1:2 with lines lc rgb '{2}' lw 2 dt {5} title {3}, "
        "${1} using ($3 == 1 ? $1 : NaN):2 with points lc rgb '{2}' lw 2 pt {4} ps 1.4 notitle",
        plots.empty() ? "" : ", ", one.block, one.look.colour, report::gnuplot_literal(one.label),
        one.look.open, one.look.dash);
  }
  return fmt::format(
      "set title '(c) branches from the exact density without losses; marks: folds'\n{}"
      "unset logscale y\nset format y '%g'\nset autoscale\n"
      "set xrange [0:1.02]\nset xtics 0.1\n"
      "set xlabel 'fraction of the way to the full problem'\n"
      "set ylabel 'norm of the coefficients'\n"
      "plot {}\n\n",
      margins({0.09, 0.97, 0.42, 0.08}), plots);
}

}  // namespace

std::string figure(const OrderStudy& study, const std::string& file_stem) {
  const auto followed = branches(study);
  const bool with_branches = !followed.empty();
  int highest = 2;
  for (const auto& row : study.rows) highest = std::max(highest, row.order);
  const double top = with_branches ? 0.91 : 0.86, bottom = with_branches ? 0.55 : 0.13;
  std::string text =
      report::figure_output(file_stem, {.width = 1100, .height = with_branches ? 950 : 560});
  for (const auto& all : {formulations_of(study, true), formulations_of(study, false), followed}) {
    for (const auto& one : all) text += data_block(one.block, one.points);
  }
  text += fmt::format(
      "set tics out nomirror\nset grid ytics lc rgb '#DDDDDD'\nset key top right\n"
      "set logscale y\nset format y '10^{{%L}}'\n"
      "set xrange [1:{}]\nset xtics 2\nset xlabel 'order {{/:Italic n}}'\n"
      "set multiplot title {} font ',14'\n\n",
      highest + 1, report::figure_title(study.problem));
  text += distance_panel(study, "(a) displacement", Variable::y, {0.09, 0.49, top, bottom});
  text += distance_panel(study, "(b) velocity; open marks: not ok", Variable::ydot,
                         {0.57, 0.97, top, bottom});
  if (with_branches) text += branch_panel(followed);
  return text + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::study
