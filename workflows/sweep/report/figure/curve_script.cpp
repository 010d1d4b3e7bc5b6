#include "workflows/sweep/report/figure/curve_script.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/figure/frame.hpp"
#include "report/figure/text.hpp"

namespace fpkcheck::sweep {
using report::PanelGrid;
namespace {

// The style of a method's line without marks.
std::string line_of(const CurveData& data, std::size_t m) {
  const transform::PlotStyle& plot_style = data.plot_style(m);
  constexpr double kThin = 1.5, kBroad = 2.5;  // limits: neighbouring curves need moderate widths
  return fmt::format("with {} lc rgb '{}' lw {:.2g}{}", data.has_words() ? "points" : "linespoints",
                     plot_style.colour, std::clamp(plot_style.width, kThin, kBroad),
                     data.has_words() ? "" : " dt " + report::dash_type(plot_style.dash));
}

}  // namespace

std::string curve_plot_command(const CurveData& data, std::size_t slice, std::size_t m,
                               int column) {
  return fmt::format("$curve_{}_{} using {}:{}:{} {} pt variable ps {} notitle", slice, m,
                     static_cast<int>(abscissa), column, static_cast<int>(mark_type),
                     line_of(data, m), data.mark_size());
}

report::Legend curves_legend(const CurveData& data, const std::vector<std::size_t>& methods,
                             bool has_open_marks) {
  report::Legend legend{{}, 4};
  for (const std::size_t m : methods) {
    legend.entries.push_back(
        {fmt::format("NaN {} pt {} ps 1.1", line_of(data, m), data.marks(m).filled),
         data.view().plan().methods[m].id()});
  }
  if (has_open_marks) {
    legend.entries.push_back({"NaN with points lc rgb '#444444' lw 2 pt 6 ps 1.1", "open: not ok"});
  }
  return legend;
}

PanelGrid curves_grid(const CurveData& data, const report::Legend& legend) {
  const auto slices = static_cast<int>(data.layout().slices.size());
  const SweepView& view = data.view();
  const bool narrow = view.medium() == report::FigureWidth::one_column;
  return {.medium = view.medium(),
          .width = view.width(),
          .columns = narrow ? 1 : 2,
          .rows = narrow ? 2 * slices : slices,
          .panel_height = slices > 1 ? 250
                          : narrow   ? 230
                                     : 350,
          .title_height = view.title().height,
          .legend_height = report::legend_height(legend, view.width())};
}

std::string curves_script_beginning(const CurveData& data, const PanelGrid& grid,
                                    const std::string& file_stem) {
  return report::gnuplot_output_commands(file_stem, grid.size()) + data.blocks() + '\n' +
         PanelGrid::kLabels +
         fmt::format(
             "set tics out nomirror\nset border 3\n"
             "set grid ytics lc rgb '#DDDDDD' lt 1 lw 0.6\nunset key\n{}",
             data.view().title().command) +
         data.layout().along.commands('x');
}

std::string curves_panel(const CurveData& data, const PanelGrid& grid, std::size_t slice,
                         transform::Variable variable) {
  const bool is_y = variable == transform::Variable::y;
  const std::string& name = data.layout().slices[slice].name;
  return report::panel_position_commands(grid.panel_box(2 * slice + (is_y ? 0 : 1))) +
         fmt::format("set title {}\n",
                     report::gnuplot_literal(fmt::format(
                         "({}) {}{}{}", static_cast<char>('a' + 2 * slice + (is_y ? 0 : 1)),
                         is_y ? "displacement" : "velocity", name.empty() ? "" : ", ", name)));
}

}  // namespace fpkcheck::sweep
