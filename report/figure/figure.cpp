#include "report/figure/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "report/figure/frame.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/layout.hpp"
#include "report/figure/script_parts.hpp"
#include "report/figure/text.hpp"

namespace fpkcheck::report {
namespace {

bool has_open_marks(const FigureSeries& series) {
  return !series.symbol.empty() && std::ranges::any_of(series.points, &FigurePoint::open);
}

const char* gnuplot_dash_type(const std::string& dash) {
  return dash == "dot"        ? "(2,4)"
         : dash == "dash"     ? "(8,4)"
         : dash == "longdash" ? "(20,6)"
                              : "solid";
}

// The style of a series after "with lines", "with points" or "with linespoints".
std::string series_style(const FigureSeries& series) {
  std::string style = fmt::format("linewidth {:g} linecolor rgb {}", series.line_width,
                                  gnuplot_string(series.colour));
  if (!series.dash.empty()) style += fmt::format(" dashtype {}", gnuplot_dash_type(series.dash));
  if (!series.symbol.empty()) {
    style += fmt::format(" pointtype {} pointsize {:g}", point_types(series.symbol).filled,
                         series.mark_size);
  }
  return style;
}

std::string series_kind(const FigureSeries& series) {
  return series.symbol.empty() ? "lines" : series.dash.empty() ? "points" : "linespoints";
}

// An open mark is a white filled mark below the outline of the mark, so that the line does not
// cross the mark.
std::string series_plot(const FigureSeries& series, const std::string& block) {
  std::string plot = fmt::format("${} using 1:2 with {} {} notitle", block, series_kind(series),
                                 series_style(series));
  if (!has_open_marks(series)) return plot;
  const auto [filled, open] = point_types(series.symbol);
  for (const auto& [type, colour] :
       {std::pair{filled, std::string("white")}, {open, series.colour}}) {
    plot += fmt::format(
        ", \\\n     ${} using 1:($3 == 1 ? $2 : NaN) with points linewidth {:g} linecolor rgb {} "
        "pointtype {} pointsize {:g} notitle",
        block, series.line_width, gnuplot_string(colour), type, series.mark_size);
  }
  return plot;
}

std::string series_block(char letter, std::size_t number) {
  return fmt::format("{}{}", letter, number);
}

std::string axis_commands(const FigureAxis& axis, char name) {
  return fmt::format(
      "set {0}label {1}\nset {0}range [{2:.6g}:{3:.6g}]\nset {0}tics {4}\n{5}", name,
      gnuplot_text(axis.label), axis.from, axis.to,
      axis.tic_step > 0 ? fmt::format("{:g}", axis.tic_step) : "autofreq",
      axis.is_logarithmic
          ? fmt::format("set logscale {0}\nset format {0} {1}\n", name, kPowerOfTenFormat)
          : fmt::format("unset logscale {0}\nset format {0} '%g'\n", name));
}

Legend figure_legend(const Figure& figure) {
  Legend legend{{}, 4};
  std::set<std::string> listed;
  bool any_open = false;
  for (const auto& panel : figure.panels) {
    for (const auto& series : panel.series) {
      any_open = any_open || has_open_marks(series);
      if (!listed.insert(series.name).second) continue;
      legend.entries.push_back(
          {fmt::format("NaN with {} {}", series_kind(series), series_style(series)), series.name});
    }
  }
  if (any_open) {
    legend.entries.push_back(
        {"NaN with points linecolor rgb '#444444' linewidth 2 pointtype 6 pointsize 1.3",
         "open: not ok"});
  }
  return legend;
}

}  // namespace

std::string figure_script(const Figure& figure, const problem::Problem& problem,
                          const std::string& file_stem, FigureWidth width) {
  assert(!figure.panels.empty());
  constexpr int kOnScreen = 1100;
  const bool narrow = width == FigureWidth::one_column;
  const Legend legend = figure_legend(figure);
  PanelGrid grid = panel_grid(width, kOnScreen);
  (narrow ? grid.rows : grid.columns) = static_cast<int>(figure.panels.size());
  grid.panel_height = narrow ? 200 : 300;
  grid.legend_height = legend_height(legend, grid.width);
  const FigureTitle title = figure_title(problem, grid.size());
  grid.title_height = title.height;

  std::string data, commands;
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const FigurePanel& panel = figure.panels[k];
    const auto letter = static_cast<char>('a' + k);
    std::vector<std::string> plots;
    for (const auto& series : panel.series) {
      std::string rows;
      for (const auto& point : series.points) {
        rows += fmt::format("{:g} {:.6g} {:d}\n", point.x, point.y, point.open);
      }
      const std::string block = series_block(letter, plots.size());
      data += data_block(block, rows);
      plots.push_back(series_plot(series, block));
    }
    commands += fmt::format("set title '({}) {}'\n{}{}{}plot {}\n\n", letter, panel.title,
                            panel_position_commands(grid.panel_box(k)), axis_commands(panel.x, 'x'),
                            axis_commands(panel.y, 'y'), fmt::join(plots, ", \\\n     "));
  }
  return gnuplot_output_commands(file_stem, grid.size()) +
         "# Columns: abscissa, ordinate, 1 for an open mark\n" + data +
         "set tics out nomirror\nset border 3\nset grid ytics linetype 1 dashtype solid linecolor "
         "rgb '#DDDDDD' linewidth 0.6\nunset key\n" +
         PanelGrid::kLabels + title.command + commands +
         legend_strip_commands(legend, grid.size()) + "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
