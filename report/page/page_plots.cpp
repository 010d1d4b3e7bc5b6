#include "report/page/page_plots.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "report/page/html_elements.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;

// Returns the position of the label beside a mark of a plot. The label position differs between
// neighbouring marks of a series and between series, so that fewer labels overlap.
const char* label_position(std::size_t series, std::size_t point) {
  constexpr std::array kSides{"top center", "bottom center", "top left", "bottom right"};
  return kSides[(series + point) % kSides.size()];
}

// Returns the name of an axis of a plot row in plotly.js: "x", "x2", ..
std::string axis_name(char letter, std::size_t row) {
  return row == 0 ? std::string(1, letter) : fmt::format("{}{}", letter, row + 1);
}

// Returns the error bars of a series: the lengths of the confidence intervals above and below each
// point.
Json error_bars_json(const FigureSeries& series) {
  Json above = Json::array(), below = above;
  for (const auto& point : series.points) {
    above.push_back(std::isfinite(point.upper) ? point.upper - point.y : 0);
    below.push_back(std::isfinite(point.lower) ? point.y - point.lower : 0);
  }
  return {{"type", "data"},      {"symmetric", false}, {"array", above},
          {"arrayminus", below}, {"thickness", 1},     {"width", 2}};
}

// Returns the trace of a bar series. Bars are horizontal on the report page, since the names of
// bars are long.
Json bar_trace(const FigureSeries& series) {
  constexpr double kPaleOpacity = 0.4;
  Json x = Json::array(), y = x, widths = x, names = x, opacities = x;
  for (const auto& point : series.points) {
    x.push_back(point.y);
    y.push_back(point.x);
    widths.push_back(point.width);
    names.push_back(escape_plotly_text(point.name));
    opacities.push_back(point.open ? kPaleOpacity : 1);
  }
  return {
      {"type", "bar"},
      {"orientation", "h"},
      {"x", x},
      {"y", y},
      {"width", widths},
      {"customdata", names},
      {"error_x", error_bars_json(series)},
      {"marker",
       {{"color", series.colour},
        {"opacity", opacities},
        {"pattern",
         {{"shape", series.hatch}, {"fillmode", "overlay"}, {"fgcolor", "#ffffff"}, {"size", 6}}}}},
      {"hovertemplate", "%{customdata}: %{x:.3g}"}};
}

/// The plotly.js traces of one plot, and the arrays of numbers that these traces share.
class PlotlyTraces {
 public:
  void add(const FigurePanel& panel, std::size_t row) {
    const bool is_horizontal = std::ranges::any_of(panel.series, &FigureSeries::is_bars);
    for (const auto& series : panel.series) {
      if (series.points.empty()) continue;
      const bool has_intervals = std::ranges::any_of(
          series.points, [](const FigurePoint& point) { return std::isfinite(point.upper); });
      if (has_intervals && !series.is_bars) add_band(series, panel, row);
      Json trace = series.is_bars ? bar_trace(series) : series_trace(series);
      if (is_horizontal && !series.is_bars) {
        std::swap(trace["x"], trace["y"]);
        trace["hovertemplate"] = "%{customdata}: %{x:.3g}<extra></extra>";
      }
      if (!listed_.insert(series.name).second) trace["showlegend"] = false;
      push_trace(std::move(trace), series, row);
    }
  }
  const Json& traces() const { return traces_; }
  const Json& arrays() const { return arrays_; }

 private:
  void push_trace(Json trace, const FigureSeries& series, std::size_t row) {
    trace.update({{"name", escape_plotly_text(series.name)},
                  {"legendgroup", series.group},
                  {"legendrank", series.rank},
                  {"xaxis", axis_name('x', row)},
                  {"yaxis", axis_name('y', row)}});
    if (series.is_hidden) trace["visible"] = "legendonly";
    traces_.push_back(std::move(trace));
  }

  // Returns the x or y coordinates of the points of a series. Long arrays of coordinates are stored
  // once and referred to by name.
  Json coordinates(const FigureSeries& series, double FigurePoint::*member) {
    constexpr std::size_t kLong = 50;
    std::vector<double> values;
    for (const auto& point : series.points) values.push_back(point.*member);
    if (values.size() < kLong) return values;  // the JSON library writes NaN as null
    const PlotlyNumberArray array = encode_float_array(values);
    const auto [found, is_new] = names_.try_emplace(array.bdata, fmt::format("{}", names_.size()));
    if (is_new) arrays_[found->second] = array;
    return "@" + found->second;
  }

  void add_band(const FigureSeries& series, const FigurePanel& panel, std::size_t row) {
    // On a logarithmic axis, ends of confidence intervals that are <= 0 are replaced by a value far
    // below the axis.
    const double least =
        panel.y.is_logarithmic ? 1e-5 * panel.y.from : -std::numeric_limits<double>::infinity();
    for (const bool is_upper : {false, true}) {
      FigureSeries edge = series;
      for (auto& point : edge.points)
        point.y = std::max(is_upper ? point.upper : point.lower, least);
      Json trace{{"type", "scatter"},
                 {"mode", "lines"},
                 {"x", coordinates(edge, &FigurePoint::x)},
                 {"y", coordinates(edge, &FigurePoint::y)},
                 {"showlegend", false},
                 {"line", {{"width", 0}}},
                 {"hoverinfo", "skip"}};
      if (is_upper) trace.update({{"fill", "tonexty"}, {"fillcolor", "rgba(0,0,0,0.18)"}});
      push_trace(std::move(trace), series, row);
    }
  }

  Json series_trace(const FigureSeries& series) {
    Json names = Json::array(), labels = names, positions = names, symbols = names, colours = names;
    for (const auto& point : series.points) {
      names.push_back(escape_plotly_text(point.name));
      labels.push_back(escape_plotly_text(point.label));
      positions.push_back(label_position(traces_.size(), positions.size()));
      const bool is_open = point.open && !series.symbol.ends_with("-open");
      symbols.push_back(series.symbol + (is_open ? "-open" : ""));
      colours.push_back(point.colour.empty() ? series.colour : point.colour);
    }
    const auto any_has = [&](std::string FigurePoint::*text) {
      return std::ranges::any_of(series.points,
                                 [&](const FigurePoint& point) { return !(point.*text).empty(); });
    };
    const bool has_labels = any_has(&FigurePoint::label);
    // Sparse marks on lines are omitted, since colours and the mouse pointer distinguish lines on
    // the report page.
    const bool has_marks = !series.symbol.empty() && (series.dash.empty() || series.mark_step == 1);
    std::string mode = series.dash.empty() ? "" : "lines";
    if (has_marks) mode += mode.empty() ? "markers" : "+markers";
    if (has_labels) mode += "+text";
    Json trace{{"type", "scatter"},
               {"mode", mode},
               {"x", coordinates(series, &FigurePoint::x)},
               {"y", coordinates(series, &FigurePoint::y)},
               {"hovertemplate", "%{y:.4g}"}};
    if (!series.dash.empty()) {
      trace["line"] = {{"color", series.colour},
                       {"width", series.line_width},
                       {"dash", plotly_dash_type(series.dash)}};
    }
    if (has_marks) {
      constexpr double kPixelsPerPointSize = 7;
      trace["marker"] = {{"color", colours},
                         {"symbol", symbols},
                         {"size", std::round(kPixelsPerPointSize * series.mark_size)}};
      if (series.mark_step > 1) {
        trace["marker"]["maxdisplayed"] = series.points.size() / series.mark_step;
      }
    }
    if (any_has(&FigurePoint::name)) {
      trace["customdata"] = names;
      trace["hovertemplate"] = "%{customdata}: %{y:.3g}<extra></extra>";
    }
    if (has_labels) {
      trace["text"] = labels;
      trace["textposition"] = positions;
      trace["textfont"] = {{"size", 10}};
      trace["cliponaxis"] = false;
      trace["hovertemplate"] = "%{customdata}: %{y:.3g} at %{x:.2g}<extra></extra>";
    }
    return trace;
  }

  Json traces_ = Json::array(), arrays_ = Json::object();
  // Names of arrays of numbers, with the base64 text of the numbers as key.
  std::map<std::string, std::string> names_;
  std::set<std::string> listed_;  // names of series that already have a legend entry
};

// @param is_zoomed whether readers zoom into the axis, which needs automatic steps of tics
Json axis_json(const FigureAxis& axis, bool is_zoomed) {
  Json json{{"title", {{"text", enhanced_text_to_plotly(axis.label)}}}};
  if (!axis.tics.empty()) {
    Json places = Json::array(), labels = places;
    for (const auto& tic : axis.tics) {
      places.push_back(tic.place);
      labels.push_back(enhanced_text_to_plotly(tic.label));
    }
    json.update({{"tickvals", places}, {"ticktext", labels}});
  }
  if (axis.is_logarithmic) {
    json.update({{"type", "log"},
                 {"range", {std::log10(axis.from), std::log10(axis.to)}},
                 {"exponentformat", "power"},
                 {"dtick", 1},
                 {"automargin", true}});
  } else {
    json.update({{"range", {axis.from, axis.to}}, {"exponentformat", "power"}});
    if (axis.tic_step > 0 && !is_zoomed) json.update({{"dtick", axis.tic_step}, {"tick0", 0}});
  }
  return json;
}

bool has_named_points(const FigurePanel& panel) {
  return std::ranges::any_of(panel.series, [](const FigureSeries& series) {
    return std::ranges::any_of(series.points,
                               [](const FigurePoint& point) { return !point.name.empty(); });
  });
}

// Returns the plotly.js layout of a plot whose rows are panels, beginning with the lowest row.
Json layout_json(std::span<const FigurePanel> rows) {
  constexpr double kGap = 0.07;  // gap between rows, as a fraction of the plot height
  const bool is_single = rows.size() == 1;
  const double height = (1 + kGap) / static_cast<double>(rows.size()) - kGap;
  Json layout = Json::object();
  // If the points of a series have no names, one label on the plot shows the values of all curves
  // at an abscissa.
  if (std::ranges::any_of(rows, has_named_points)) layout["hovermode"] = "closest";
  for (std::size_t row = 0; row < rows.size(); ++row) {
    const FigurePanel& panel = rows[row];
    Json x = axis_json(panel.x, !is_single), y = axis_json(panel.y, !is_single);
    if (!is_single) {
      const double bottom = static_cast<double>(row) * (height + kGap);
      y["domain"] = {bottom, std::min(1.0, bottom + height)};
      x["anchor"] = axis_name('y', row);
      y["anchor"] = axis_name('x', row);
      if (row > 0) x["title"]["text"] = "";
    }
    const std::string number = row == 0 ? "" : std::to_string(row + 1);
    if (std::ranges::any_of(panel.series, &FigureSeries::is_bars)) {
      layout["barmode"] = "overlay";
      std::swap(x, y);
      y["range"] = {panel.x.to, panel.x.from};
      y["showgrid"] = false;
    }
    layout["xaxis" + number] = x;
    layout["yaxis" + number] = y;
    if (panel.note.empty()) continue;
    layout["annotations"].push_back({{"xref", axis_name('x', row)},
                                     {"yref", axis_name('y', row) + " domain"},
                                     {"x", 0},
                                     {"y", 0.97},
                                     {"xanchor", "left"},
                                     {"xshift", 8},
                                     {"showarrow", false},
                                     {"text", escape_plotly_text(panel.note)}});
  }
  return layout;
}

std::size_t plot_height(std::span<const FigurePanel> rows) {
  const auto& panel = rows.front();
  if (std::ranges::any_of(panel.series, &FigureSeries::is_bars)) {
    return 140 + 44 * panel.x.tics.size();
  }
  return rows.size() == 1 ? 340 : 40 + 240 * rows.size();
}

}  // namespace

std::string plots_html(const std::vector<ReportPagePlot>& plots) {
  std::string html = "<div class=\"plots\">\n";
  for (const auto& plot : plots) {
    html += fmt::format(
        "<figure>\n<figcaption>{0}</figcaption>\n"
        "<div class=\"plot\" id=\"{1}\" role=\"img\" aria-label=\"{0}\"></div>\n</figure>\n",
        escape_html(plot.caption), escape_html(plot.id));
  }
  return html + "</div>\n";
}

std::string plots_json(const std::vector<ReportPagePlot>& plots) {
  std::vector<std::string> entries;
  for (const auto& plot : plots) {
    entries.push_back(
        fmt::format(R"({{"id":{},"figure":{}}})", nlohmann::json(plot.id).dump(), plot.figure));
  }
  return fmt::format("[{}]", fmt::join(entries, ","));
}

std::string escape_plotly_text(std::string_view text) {
  std::string shown;
  for (const char c : text) {
    if (c == '&') {
      shown += "&amp;";
    } else if (c == '<') {
      shown += "&lt;";
    } else {
      shown += c;
    }
  }
  return shown;
}

std::string enhanced_text_to_plotly(std::string_view enhanced) {
  constexpr std::string_view kItalic = "{/:Italic ";
  std::string html;
  while (!enhanced.empty()) {
    const char c = enhanced[0];
    std::size_t length = 1;
    if (enhanced.starts_with(kItalic)) {
      const auto end = std::min(enhanced.find('}'), enhanced.size() - 1);
      const auto symbol = enhanced.substr(kItalic.size(), end - kItalic.size());
      html += "<i>" + escape_plotly_text(symbol) + "</i>";
      length = end + 1;
    } else if (enhanced.size() > 1 && (c == '_' || c == '^')) {
      const bool in_braces = enhanced[1] == '{';
      const auto end = in_braces ? std::min(enhanced.find('}'), enhanced.size() - 1) : 2;
      const auto from = in_braces ? 2 : 1;
      html += fmt::format("<{0}>{1}</{0}>", c == '_' ? "sub" : "sup",
                          escape_plotly_text(enhanced.substr(from, end - from)));
      length = in_braces ? end + 1 : end;
    } else if (enhanced.size() > 1 && c == '\\') {
      html += escape_plotly_text(enhanced.substr(1, 1));
      length = 2;
    } else {
      html += c == '\'' ? "\u2032" : escape_plotly_text(enhanced.substr(0, 1));
    }
    enhanced.remove_prefix(length);
  }
  return html;
}

std::string plotly_dash_type(const std::string& gnuplot_dash) {
  std::string dash;
  for (const char c : gnuplot_dash) {
    if (c == ',' || c == ')') dash += "px";
    if (c != '(' && c != ')') dash += c;
  }
  return dash;
}

std::vector<ReportPagePlot> make_page_plots(const Figure& figure, const std::string& prefix) {
  std::vector<ReportPagePlot> plots;
  for (auto from = figure.panels.begin(); from != figure.panels.end();) {
    const auto to = std::find_if(from, figure.panels.end(), [&](const FigurePanel& panel) {
      return panel.id != from->id || panel.id.empty();
    });
    const std::span rows(from, std::max(to, from + 1));
    from += static_cast<std::ptrdiff_t>(rows.size());
    const FigurePanel& panel = rows.front();
    if (panel.id.empty()) continue;
    PlotlyTraces traces;
    for (std::size_t row = 0; row < rows.size(); ++row) traces.add(rows[row], row);
    const Json json{{"height", plot_height(rows)},
                    {"arrays", traces.arrays()},
                    {"data", traces.traces()},
                    {"layout", layout_json(rows)}};
    plots.push_back({prefix + '-' + panel.id, panel.caption,
                     json.dump(-1, ' ', false, Json::error_handler_t::replace)});
  }
  return plots;
}

}  // namespace fpkcheck::report
