#include "report/figure/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>

#include "report/figure/figure_layout.hpp"
#include "report/figure/gnuplot.hpp"
#include "report/figure/script_text.hpp"

namespace fpkcheck::report {
namespace {

// Width of a colour bar, and width of a colour bar with tics and label, in pixels.
constexpr int kColourBarWidth = 14, kColourBarSpace = 110;

/// The data blocks of a gnuplot script. Figure series with the same points share a data block.
class GnuplotDataBlocks {
 public:
  /// @param rows rows of the data block, each ended by a newline
  /// @return name of the data block
  std::string add(const std::string& rows) {
    const auto [block, is_new] = names_.try_emplace(rows, fmt::format("data{}", names_.size()));
    if (is_new) text_ += gnuplot_data_block(block->second, rows);
    return '$' + block->second;
  }
  const std::string& text() const { return text_; }

 private:
  std::map<std::string, std::string> names_;
  std::string text_;
};

std::string gnuplot_number(double value, bool is_logarithmic) {
  return std::isfinite(value) && (value > 0 || !is_logarithmic) ? fmt::format("{:.6g}", value)
                                                                : "NaN";
}

bool has_points(const FigureSeries& series) {
  return std::ranges::any_of(series.points, [](const FigurePoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y);
  });
}

bool has_open_bars(const FigureSeries& series) {
  return series.is_bars && std::ranges::any_of(series.points, &FigurePoint::open);
}

bool has_open_marks(const FigureSeries& series) {
  const auto [filled, open] = gnuplot_point_types(series.symbol);
  return !series.symbol.empty() && filled != open &&
         std::ranges::any_of(series.points, &FigurePoint::open);
}

bool has_intervals(const FigureSeries& series) {
  return std::ranges::any_of(series.points,
                             [](const FigurePoint& point) { return std::isfinite(point.upper); });
}

std::string gnuplot_plot_style(const FigureSeries& series) {
  return series.is_area          ? "filledcurves"
         : series.is_bars        ? has_intervals(series) ? "boxerrorbars" : "boxes"
         : has_intervals(series) ? "yerrorbars"
         : series.symbol.empty() ? "lines"
         : series.dash.empty()   ? "points"
                                 : "linespoints";
}

constexpr double kPaleFraction = 0.3;

// Mixes a colour "#RRGGBB" with white.
std::string mix_with_white(const std::string& colour) {
  std::string mixed = "#";
  for (const std::size_t position : {1, 3, 5}) {
    const int component = std::stoi(colour.substr(position, 2), nullptr, 16);
    mixed += fmt::format("{:02X}", 255 - std::lround(kPaleFraction * (255 - component)));
  }
  return mixed;
}

// Since gnuplot has no fill density for patterns, pale patterns are drawn in a colour mixed with
// white.
std::string bar_style_options(const FigureSeries& series, const std::string& kind, bool is_pale) {
  const std::string colour = quote_for_gnuplot(series.colour);
  if (series.hatch.empty()) {
    return fmt::format("with {} fillstyle solid {:.1f} border rgb {} linecolor rgb {}", kind,
                       is_pale ? kPaleFraction : 1, colour, colour);
  }
  return fmt::format("with {} fillstyle pattern {} border rgb {} linecolor rgb {}", kind,
                     gnuplot_fill_pattern(series.hatch), colour,
                     is_pale ? quote_for_gnuplot(mix_with_white(series.colour)) : colour);
}

// Returns the gnuplot plot style of a series, in the colour of the series or of its legend entry.
// The colour is quoted as a gnuplot string, since plot styles may come from files.
// @param kind plot style of gnuplot: gnuplot_plot_style(), or only the lines or points of the
//        series
std::string series_style_options(const FigureSeries& series, const std::string& kind,
                                 const std::string& colour, bool is_open = false) {
  if (series.is_area) {
    return fmt::format("with {0} fillstyle solid 0.4 border rgb {1} fillcolor rgb {1}", kind,
                       quote_for_gnuplot(colour));
  }
  if (series.is_bars) return bar_style_options(series, kind, is_open);
  std::string style = fmt::format("with {} linewidth {:g} linecolor rgb {}", kind,
                                  series.line_width, quote_for_gnuplot(colour));
  if (kind.starts_with("lines")) style += fmt::format(" dashtype {}", valid_dash_type(series.dash));
  if (kind == "lines") return style;
  const auto [filled, open] = gnuplot_point_types(series.symbol);
  return style +
         fmt::format(" pointtype {} pointsize {:g}", is_open ? open : filled, series.mark_size);
}

// Returns the gnuplot data block of a series with the columns abscissa, ordinate, 1 for an open
// mark, width of the bar, and ends of the interval.
std::string add_series_data_block(const FigureSeries& series, const FigurePanel& panel,
                                  GnuplotDataBlocks& blocks) {
  const bool is_logarithmic = panel.y.is_logarithmic, with_intervals = has_intervals(series);
  std::string rows;
  for (const auto& point : series.points) {
    if (series.is_area && !std::isfinite(point.y)) {
      rows += '\n';  // an empty line separates areas
      continue;
    }
    rows += fmt::format("{} {} {:d}", gnuplot_number(point.x, panel.x.is_logarithmic),
                        gnuplot_number(point.y, is_logarithmic), point.open);
    if (series.is_bars) rows += fmt::format(" {:.6g}", point.width);
    if (with_intervals) {
      // A confidence interval that reaches below a logarithmic axis ends at the axis.
      const double lower = is_logarithmic ? std::max(point.lower, panel.y.from) : point.lower;
      // The program gnuplot would omit a bar without a confidence interval.
      const bool is_empty = series.is_bars && !std::isfinite(point.upper);
      rows += fmt::format(" {} {}", gnuplot_number(is_empty ? point.y : lower, false),
                          gnuplot_number(is_empty ? point.y : point.upper, false));
    }
    rows += '\n';
  }
  return blocks.add(rows);
}

// An open mark is a white filled mark below an outline, so that the line of the series does not
// cross the mark.
std::vector<std::string> series_plot_commands(const FigureSeries& series, const FigurePanel& panel,
                                              GnuplotDataBlocks& blocks) {
  const std::string block = add_series_data_block(series, panel, blocks),
                    kind = gnuplot_plot_style(series);
  const auto plot = [&](const std::string& every, const std::string& columns,
                        const std::string& style) {
    return fmt::format("{}{} using {} {} notitle", block, every, columns, style);
  };
  std::vector<std::string> plots;
  if (series.is_bars) {
    for (const bool is_open : {false, true}) {
      if (std::ranges::count(series.points, is_open, &FigurePoint::open) == 0) continue;
      plots.push_back(plot("",
                           fmt::format("1:($3 == {:d} ? $2 : NaN){}", is_open,
                                       has_intervals(series) ? ":5:6:4" : ":4"),
                           series_style_options(series, kind, series.colour, is_open)));
    }
    return plots;
  }
  const std::string columns = series.is_area         ? fmt::format("1:({:.6g}):2", panel.y.from)
                              : kind == "yerrorbars" ? "1:2:4:5"
                                                     : "1:2";
  std::string every;
  if (series.mark_step > 1) {
    every = fmt::format(" every {}::{}", series.mark_step, series.first_mark);
  }
  if (kind == "linespoints" && series.mark_step > 1) {
    plots = {plot("", columns, series_style_options(series, "lines", series.colour)),
             plot(every, columns, series_style_options(series, "points", series.colour))};
  } else {
    plots = {plot(every, columns, series_style_options(series, kind, series.colour))};
  }
  if (!has_open_marks(series)) return plots;
  const std::string open_points = "1:($3 == 1 ? $2 : NaN)";
  plots.push_back(plot(every, open_points, series_style_options(series, "points", "white")));
  plots.push_back(
      plot(every, open_points, series_style_options(series, "points", series.colour, true)));
  return plots;
}

std::string heat_map_plot_command(const FigureHeatMap& map, GnuplotDataBlocks& blocks) {
  std::string rows;
  for (const auto& [x, y, value] : map.discs) {
    rows += fmt::format("{:.6g} {:.6g} {}\n", x, y, gnuplot_number(value, false));
  }
  if (map.values.empty()) {
    return fmt::format(
        "{} using 1:2:3 with points pointtype 7 pointsize {:.3g} linecolor palette "
        "notitle",
        blocks.add(rows), map.disc_size);
  }
  const std::size_t map_rows = map.values.size() / map.columns;
  const double width = (map.x_range[1] - map.x_range[0]) / static_cast<double>(map.columns),
               height = (map.y_range[1] - map.y_range[0]) / static_cast<double>(map_rows),
               x = map.x_range[0] + width / 2, y = map.y_range[0] + height / 2;
  // The program gnuplot cannot draw a single row or column of cells as an image, and warns about a
  // matrix with missing values.
  const bool is_image = map.columns > 1 && map_rows > 1;
  const bool is_matrix =
      is_image && std::ranges::all_of(map.values, [](double v) { return std::isfinite(v); });
  for (std::size_t k = 0; k < map.values.size(); ++k) {
    const bool is_end = (k + 1) % map.columns == 0;
    const std::string value = gnuplot_number(map.values[k], false);
    rows += is_matrix
                ? fmt::format("{}{}", value, is_end ? '\n' : ' ')
                : fmt::format(
                      "{:.6g} {:.6g} {}\n{}", x + static_cast<double>(k % map.columns) * width,
                      y + static_cast<double>(k / map.columns) * height, value, is_end ? "\n" : "");
  }
  const std::string block = blocks.add(rows);
  if (is_matrix) {
    return fmt::format(
        "{} matrix using ({:.8g}+{:.8g}*$1):({:.8g}+{:.8g}*$2):3 with image @cells notitle", block,
        x, width, y, height);
  }
  return fmt::format(
      "{} using {} notitle", block,
      is_image ? "1:2:3 with image @cells"
               : fmt::format("1:2:({:.6g}):({:.6g}):3 with boxxyerror fillstyle solid noborder "
                             "linecolor palette",
                             width / 2, height / 2));
}

std::string panel_letter(std::size_t panel) {
  constexpr std::size_t kLetters = 26;
  const std::string letter(1, static_cast<char>('a' + panel % kLetters));
  return panel < kLetters ? letter : panel_letter(panel / kLetters - 1) + letter;
}

/// @param name name of the axis in gnuplot: x, y, or cb for the colours of a map
std::string axis_commands(const FigureAxis& axis, const std::string& name) {
  std::vector<std::string> tics;
  for (const auto& tic : axis.tics) {
    tics.push_back(fmt::format("{} {:.6g}", gnuplot_string_expression(tic.label), tic.place));
  }
  return fmt::format(
      "unset logscale {0}\nset {0}label {1}\nset {0}range [{2:.6g}:{3:.6g}]\nset {0}tics {4}\n"
      "{5}set format {0} {6}\n",
      name, gnuplot_string_expression(axis.label), axis.from, axis.to,
      !tics.empty()       ? fmt::format("({}){}", fmt::join(tics, ", "),
                                  axis.rotated_tics ? " rotate by 35 right" : "")
      : axis.tic_step > 0 ? fmt::format("{:g}", axis.tic_step)
                          : "autofreq",
      axis.is_logarithmic ? fmt::format("set logscale {}\n", name) : "",
      axis.is_logarithmic ? kPowerOfTenFormat : "say('%h', '$%h$')");
}

// The colour scale of a heat map, with a colour bar to the right of the panel.
// @param has_colour_bar whether the panel has a colour bar
std::string colour_scale_commands(const FigureHeatMap& map, const FigurePanelBox& place,
                                  int layout_width, bool has_colour_bar) {
  std::vector<std::string> colours;
  for (const auto& [position, colour] : map.colours) {
    colours.push_back(fmt::format("{:g} {}", position, quote_for_gnuplot(colour)));
  }
  return axis_commands(map.colour_axis, "cb") +
         fmt::format(
             "set palette defined ({})\n{}{}", fmt::join(colours, ", "),
             // The background of the heat map is grey, since light discs would be invisible on
             // white.
             map.values.empty() ? "set object 1 rectangle from graph 0,0 to graph 1,1 behind "
                                  "fillcolor rgb '#E4E4E4' fillstyle noborder\n"
                                : "",
             has_colour_bar
                 ? fmt::format(
                       "set colorbox user origin screen {:.4f},{:.4f} size screen {:.4f},{:.4f}\n",
                       place.right + 8.0 / layout_width, place.bottom,
                       static_cast<double>(kColourBarWidth) / layout_width,
                       place.top - place.bottom)
                 : "unset colorbox\n");
}

FigureLegend collect_legend(const Figure& figure) {
  FigureLegend legend{{}, 4};
  std::vector<const FigureSeries*> listed;
  bool any_open = false, any_pale = false;
  for (const auto& panel : figure.panels) {
    for (const auto& series : panel.series) {
      any_open = any_open || has_open_marks(series);
      any_pale = any_pale || has_open_bars(series);
      if (!has_points(series)) continue;
      const auto same = std::ranges::find(listed, series.name, &FigureSeries::name);
      if (same == listed.end()) {
        listed.push_back(&series);
      } else if (has_intervals(series)) {
        *same = &series;
      }
    }
  }
  std::ranges::stable_sort(listed, {}, &FigureSeries::rank);
  for (const FigureSeries* series : listed) {
    const std::string kind = series->is_bars ? "boxes" : gnuplot_plot_style(*series);
    const auto& colour = series->legend_colour.empty() ? series->colour : series->legend_colour;
    legend.entries.push_back(
        {fmt::format(
             "{} {}", kind == "yerrorbars" ? "'+' using 1:(NaN):(0):(0)" : "NaN",
             series_style_options(*series, kind, colour,
                                  series->dash.empty() && !series->is_bars &&
                                      std::ranges::all_of(series->points, &FigurePoint::open))),
         series->name + series->note});
  }
  const auto with_gap = std::ranges::find_if(figure.panels, [](const FigurePanel& panel) {
    return panel.map && !panel.map->no_value_name.empty() &&
           !std::ranges::all_of(panel.map->values,
                                [](double value) { return std::isfinite(value); });
  });
  if (with_gap != figure.panels.end()) {
    legend.entries.push_back(
        {"NaN with boxes linecolor rgb '#777777' fillstyle empty", with_gap->map->no_value_name});
  }
  if (any_open) {
    legend.entries.push_back(
        {"NaN with points linecolor rgb '#444444' linewidth 2 pointtype 6 pointsize 1.3",
         "open: not ok"});
  }
  if (any_pale) {
    legend.entries.push_back(
        {fmt::format("NaN with boxes fillstyle solid {} linecolor rgb '#000000'", kPaleFraction),
         "* not ok"});
  }
  if (!figure.legend_note.empty()) {
    legend.entries.push_back({"NaN with lines linetype nodraw", figure.legend_note});
  }
  return legend;
}

// Returns whether the heat maps of all panels have the same colours, so that a row of panels needs
// a single colour bar.
bool panels_share_colour_axis(const Figure& figure) {
  const auto& first = figure.panels.front().map;
  return std::ranges::all_of(figure.panels, [&](const FigurePanel& panel) {
    return panel.map && panel.map->colour_axis == first->colour_axis;
  });
}

PanelGrid choose_panel_grid(const Figure& figure, const FigureLegend& legend, FigureWidth width) {
  PanelGrid grid = make_panel_grid(width, figure.screen_width);
  const int panels = static_cast<int>(figure.panels.size());
  grid.columns = width == FigureWidth::one_column ? 1 : std::min(figure.columns, panels);
  grid.rows = (panels + grid.columns - 1) / grid.columns;
  grid.panel_height = width == FigureWidth::screen        ? figure.panel_height
                      : width == FigureWidth::two_columns ? 3 * figure.panel_height / 4
                                                          : 2 * figure.panel_height / 3;
  if (figure.panels.front().x.rotated_tics) grid.below = 120;
  if (panels_share_colour_axis(figure)) {
    grid.right_margin = kColourBarSpace;
  } else if (std::ranges::any_of(figure.panels, [](const auto& panel) { return !!panel.map; })) {
    grid.panel_right_margin = kColourBarSpace;
  }
  grid.legend_height = legend.entries.empty() ? 0 : legend_height(legend, grid.width);
  return grid;
}

}  // namespace

FigureSeries make_empty_figure_series(const std::string& name,
                                      const transform::PlotStyle& plot_style) {
  return {.name = name,
          .colour = plot_style.colour,
          .dash = plot_style.dash,
          .symbol = plot_style.symbol};
}

CoordinateRange coordinate_range(const std::vector<FigureSeries>& all,
                                 double FigurePoint::*coordinate, double above) {
  CoordinateRange range;
  for (const auto& series : all) {
    for (const auto& point : series.points) {
      const double value = point.*coordinate;
      if (!std::isfinite(value) || value <= above) continue;
      range = {std::min(range.least, value), std::max(range.greatest, value)};
    }
  }
  return range;
}

FigureAxis logarithmic_axis(const std::string& label, const std::vector<FigureSeries>& all,
                            double FigurePoint::*coordinate) {
  const auto range = coordinate_range(all, coordinate, 0);
  if (range.is_empty()) return {label, 0.1, 10, true};
  constexpr double kDecadesBelow = 0.3, kDecadesAbove = 0.4;
  return {label, std::pow(10, std::log10(range.least) - kDecadesBelow),
          std::pow(10, std::log10(range.greatest) + kDecadesAbove), true};
}

FigureAxis linear_axis(const std::string& label, const std::vector<FigureSeries>& all,
                       double FigurePoint::*coordinate) {
  const auto range = coordinate_range(all, coordinate);
  if (range.is_empty()) return {label, 0, 1};
  const double margin =
      std::max(0.06 * (range.greatest - range.least), 2e-4 * std::abs(range.greatest) + 1e-12);
  return {label, range.least - margin, range.greatest + margin};
}

std::string make_gnuplot_script(const Figure& figure, const std::string& file_stem,
                                FigureWidth width) {
  assert(!figure.panels.empty());
  const FigureLegend legend = collect_legend(figure);
  PanelGrid grid = choose_panel_grid(figure, legend, width);
  const FigureTitle title = make_figure_title(figure.title, grid.size());
  grid.title_height = title.height;

  // A heat map with few cells is drawn as rectangles in SVG, since SVG viewers smooth images.
  constexpr std::size_t kFewCells = 6000;
  std::size_t cells = 0;
  for (const auto& panel : figure.panels) cells += panel.map ? panel.map->values.size() : 0;
  const bool few_cells = cells <= kFewCells;
  const bool common_colours = panels_share_colour_axis(figure);
  const auto figure_columns = static_cast<std::size_t>(grid.columns);
  GnuplotDataBlocks blocks;
  std::string commands;
  for (std::size_t k = 0; k < figure.panels.size(); ++k) {
    const FigurePanel& panel = figure.panels[k];
    FigurePanelBox place = grid.panel_box(k);
    const bool is_last = k + 1 == figure.panels.size();
    if (is_last && !common_colours) place.right = grid.panel_box(0, grid.columns - 1).right;
    std::vector<std::string> plots;
    if (panel.map) {
      plots.push_back(heat_map_plot_command(*panel.map, blocks));
      commands +=
          colour_scale_commands(*panel.map, place, grid.width,
                                is_last || (k + 1) % figure_columns == 0 || !common_colours);
    }
    for (const auto& series : panel.series) {
      if (!has_points(series)) continue;
      for (auto& plot : series_plot_commands(series, panel, blocks))
        plots.push_back(std::move(plot));
    }
    if (plots.empty()) plots.push_back("NaN notitle");
    if (!panel.note.empty()) {
      commands += fmt::format("set label 1 {} at first 0, graph 0.94 offset character 1,0\n",
                              literal_gnuplot_expression(panel.note));
    }
    commands += fmt::format(
        "set title {}\n{}{}{}plot {}\nunset label 1\n\n",
        gnuplot_string_expression(fmt::format(
            "({}) {}", panel.letter.empty() ? panel_letter(k) : panel.letter, panel.title)),
        panel_position_commands(place), axis_commands(panel.x, "x"), axis_commands(panel.y, "y"),
        fmt::join(plots, ", \\\n     "));
  }
  return gnuplot_output_commands(file_stem, grid.size()) +
         "# Columns of a series: abscissa, ordinate, 1 for an open mark, width of a bar, ends of the\n"
         "# interval\n" +
         blocks.text() +
         // By default, gnuplot erases the line of an error bar in a box around the point of the
         // error bar.
         "set pointintervalbox 0.0001\n"
         "set tics out nomirror\nset border 3\nset grid ytics linetype 1 dashtype solid linecolor "
         "rgb '#DDDDDD' linewidth 0.6\nunset key\n" +
         fmt::format("cells = format eq 'svg' ? '{}' : ''\n", few_cells ? "pixels" : "") +
         PanelGrid::kLabelOffsetCommands + title.command + commands +
         (legend.entries.empty() ? ""
                                 : "unset object\n" + legend_strip_commands(legend, grid.size())) +
         "unset multiplot\nunset output\n";
}

}  // namespace fpkcheck::report
