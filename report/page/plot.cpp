#include "report/page/plot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "report/page/html.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;

// Converts gnuplot's enhanced text to the HTML of plotly.js: italics, one-letter subscripts, and
// escaped characters.
std::string plotly_markup(std::string_view enhanced) {
  constexpr std::string_view kItalic = "{/:Italic ";
  std::string html;
  while (!enhanced.empty()) {
    std::size_t length = 1;
    if (enhanced.starts_with(kItalic)) {
      const auto end = std::min(enhanced.find('}'), enhanced.size() - 1);
      const auto symbol = enhanced.substr(kItalic.size(), end - kItalic.size());
      html += "<i>" + plotly_text(symbol) + "</i>";
      length = end + 1;
    } else if (enhanced.size() > 1 && (enhanced[0] == '\\' || enhanced[0] == '_')) {
      const std::string letter = plotly_text(enhanced.substr(1, 1));
      html += enhanced[0] == '_' ? "<sub>" + letter + "</sub>" : letter;
      length = 2;
    } else {
      html += enhanced[0] == '\'' ? "\u2032" : plotly_text(enhanced.substr(0, 1));
    }
    enhanced.remove_prefix(length);
  }
  return html;
}

// The position of the label beside a mark. The position differs between neighbouring marks of a
// series and between series, so that fewer labels overlap.
const char* label_position(std::size_t series, std::size_t point) {
  constexpr std::array kSides{"top center", "bottom center", "top left", "bottom right"};
  return kSides[(series + point) % kSides.size()];
}

// The lengths of the intervals at points of a series, on both sides.
Json error_bars(const FigureSeries& series) {
  Json above = Json::array(), below = above;
  for (const auto& point : series.points) {
    above.push_back(std::isfinite(point.upper) ? point.upper - point.y : 0);
    below.push_back(std::isfinite(point.lower) ? point.y - point.lower : 0);
  }
  return {{"type", "data"},      {"symmetric", false}, {"array", above},
          {"arrayminus", below}, {"thickness", 1},     {"width", 2}};
}

// The trace of bars, which the page draws horizontally, since the names of bars are long.
Json bar_trace(const FigureSeries& series) {
  constexpr double kPaleOpacity = 0.4;
  Json x = Json::array(), y = x, widths = x, names = x, opacities = x;
  for (const auto& point : series.points) {
    x.push_back(point.y);
    y.push_back(point.x);
    widths.push_back(point.width);
    names.push_back(plotly_text(point.name));
    opacities.push_back(point.open ? kPaleOpacity : 1);
  }
  return {
      {"type", "bar"},
      {"orientation", "h"},
      {"name", plotly_text(series.name)},
      {"legendgroup", series.group},
      {"x", x},
      {"y", y},
      {"width", widths},
      {"customdata", names},
      {"error_x", error_bars(series)},
      {"marker",
       {{"color", series.colour},
        {"opacity", opacities},
        {"pattern",
         {{"shape", series.hatch}, {"fillmode", "overlay"}, {"fgcolor", "#ffffff"}, {"size", 6}}}}},
      {"hovertemplate", "%{customdata}: %{x:.3g}"}};
}

Json series_trace(const FigureSeries& series, const FigurePanel& panel, std::size_t number) {
  if (series.is_bars) return bar_trace(series);
  Json x = Json::array(), y = x, names = x, labels = x, positions = x, symbols = x, colours = x;
  const auto number_or_null = [](double value, const FigureAxis& axis) {
    const bool is_drawn = std::isfinite(value) && (value > 0 || !axis.is_logarithmic);
    return is_drawn ? Json(value) : Json();
  };
  for (const auto& point : series.points) {
    x.push_back(number_or_null(point.x, panel.x));
    y.push_back(number_or_null(point.y, panel.y));
    names.push_back(plotly_text(point.name));
    labels.push_back(plotly_text(point.label));
    positions.push_back(label_position(number, positions.size()));
    symbols.push_back(series.symbol + (point.open ? "-open" : ""));
    colours.push_back(point.colour.empty() ? series.colour : point.colour);
  }
  const auto any_has = [&](std::string FigurePoint::*text) {
    return std::ranges::any_of(series.points,
                               [&](const FigurePoint& point) { return !(point.*text).empty(); });
  };
  const bool has_labels = any_has(&FigurePoint::label);
  std::string mode = series.dash.empty() ? "" : "lines";
  if (!series.symbol.empty()) mode += mode.empty() ? "markers" : "+markers";
  if (has_labels) mode += "+text";
  Json trace{{"type", "scatter"},           {"mode", mode}, {"name", plotly_text(series.name)},
             {"legendgroup", series.group}, {"x", x},       {"y", y},
             {"hovertemplate", "%{y:.3g}"}};
  if (!series.dash.empty()) {
    trace["line"] = {
        {"color", series.colour}, {"width", series.line_width}, {"dash", plotly_dash(series.dash)}};
  }
  if (!series.symbol.empty()) {
    constexpr double kPixelsPerPointSize = 7;
    trace["marker"] = {{"color", colours},
                       {"symbol", symbols},
                       {"size", std::round(kPixelsPerPointSize * series.mark_size)}};
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

Json axis_json(const FigureAxis& axis) {
  Json json{{"title", {{"text", plotly_markup(axis.label)}}}};
  if (!axis.tics.empty()) {
    Json places = Json::array(), labels = places;
    for (const auto& tic : axis.tics) {
      places.push_back(tic.place);
      labels.push_back(plotly_markup(tic.label));
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
    json["range"] = {axis.from, axis.to};
    if (axis.tic_step > 0) json.update({{"dtick", axis.tic_step}, {"tick0", 0}});
  }
  return json;
}

}  // namespace

std::string plots_html(const std::vector<Plot>& plots) {
  std::string html = "<div class=\"plots\">\n";
  for (const auto& plot : plots) {
    html += fmt::format(
        "<figure>\n<figcaption>{0}</figcaption>\n"
        "<div class=\"plot\" id=\"{1}\" role=\"img\" aria-label=\"{0}\"></div>\n</figure>\n",
        escape_html(plot.caption), escape_html(plot.id));
  }
  return html + "</div>\n";
}

std::string plots_json(const std::vector<Plot>& plots) {
  std::vector<std::string> entries;
  for (const auto& plot : plots) {
    entries.push_back(
        fmt::format(R"({{"id":{},"figure":{}}})", nlohmann::json(plot.id).dump(), plot.figure));
  }
  return fmt::format("[{}]", fmt::join(entries, ","));
}

std::string plotly_text(std::string_view text) {
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

std::string legend_name(const transform::Solution& solution) {
  const std::string name = plotly_text(solution.id());
  return solution.is_ok() ? name : fmt::format("{} ({})", name, transform::name(solution.status));
}

std::string plotly_dash(const std::string& gnuplot_dash) {
  std::string dash;
  for (const char c : gnuplot_dash) {
    if (c == ',' || c == ')') dash += "px";
    if (c != '(' && c != ')') dash += c;
  }
  return dash;
}

std::vector<Plot> figure_plots(const Figure& figure, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const auto& panel : figure.panels) {
    if (panel.id.empty()) continue;
    const bool is_horizontal = std::ranges::any_of(panel.series, &FigureSeries::is_bars);
    Json data = Json::array();
    for (const auto& series : panel.series) {
      data.push_back(series_trace(series, panel, data.size()));
      if (!is_horizontal || series.is_bars) continue;
      std::swap(data.back()["x"], data.back()["y"]);
      data.back()["hovertemplate"] = "%{customdata}: %{x:.3g}<extra></extra>";
    }
    Json layout{
        {"hovermode", "closest"}, {"xaxis", axis_json(panel.x)}, {"yaxis", axis_json(panel.y)}};
    if (is_horizontal) {
      layout["barmode"] = "overlay";
      std::swap(layout["xaxis"], layout["yaxis"]);
      layout["yaxis"]["range"] = {panel.x.to, panel.x.from};
      layout["yaxis"]["showgrid"] = false;
    }
    const Json json{{"height", is_horizontal ? 140 + 44 * panel.x.tics.size() : 340},
                    {"arrays", Json::object()},
                    {"data", data},
                    {"layout", layout}};
    plots.push_back({prefix + '-' + panel.id, panel.caption,
                     json.dump(-1, ' ', false, Json::error_handler_t::replace)});
  }
  return plots;
}

}  // namespace fpkcheck::report
