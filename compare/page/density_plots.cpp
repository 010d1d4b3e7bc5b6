#include "compare/page/density_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/figure/content.hpp"
#include "compare/page/closest.hpp"
#include "compare/page/trace_style.hpp"
#include "compare/page/typed_array.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSmallestShown = 1e-7;
// Ends of intervals at or below zero have no logarithm; this is far below the axis.
constexpr double kFarBelow = 1e-12;

/// The rows of a plot, from the top: axes "", "2", "3" of plotly.js.
enum Row { kLinear, kLogarithmic, kDifference };

std::string axis(char letter, Row row) {
  return row == kLinear ? std::string(1, letter) : fmt::format("{}{}", letter, row + 1);
}

std::vector<double> minus(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::ranges::transform(a, b, result.begin(), std::minus{});
  return result;
}

std::vector<double> plus(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::ranges::transform(a, b, result.begin(), std::plus{});
  return result;
}

std::vector<double> at_least(std::vector<double> values, double least) {
  for (double& value : values) value = std::max(value, least);
  return values;
}

class DensityPlot {
 public:
  DensityPlot(const Json& summary_case, const FigureSide& side, std::string reference)
      : side_(side), reference_(std::move(reference)), shown_(first_shown(summary_case)) {
    for (const auto& solution : summary_case.at("solutions")) order_.push_back(solution.at("id"));
    for (const auto& drawn : side_.curves) add(drawn);
  }

  Json figure() const {
    return {{"height", reference_.empty() ? 520 : 760},
            {"arrays", arrays_},
            {"data", traces_},
            {"layout", layout()}};
  }

 private:
  void add(const DrawnCurve& drawn) {
    const std::string id = drawn.curve->solution;
    if (x_of(drawn) == id + " x") put(id + " x", drawn.curve->abscissa);
    put(id + " p", drawn.curve->density);
    if (!drawn.difference.empty()) put(id + " difference", drawn.difference);
    add_bands(drawn);
    add_curve(drawn, kLinear, "p");
    add_curve(drawn, kLogarithmic, "p");
    if (!drawn.difference.empty()) add_curve(drawn, kDifference, "difference");
  }

  // Nearly always the same bins: then the first curve's serve all.
  std::string x_of(const DrawnCurve& drawn) const {
    const MarginalCurve& first = *side_.curves.front().curve;
    const bool same = drawn.curve->abscissa == first.abscissa;
    return (same ? first.solution : drawn.curve->solution) + " x";
  }

  void put(const std::string& name, const std::vector<double>& values) {
    arrays_[name] = float_array(values);
  }

  Json trace(const DrawnCurve& drawn, Row row, const std::string& array) const {
    const std::string& id = drawn.curve->solution;
    const auto rank = std::ranges::find(order_, id) - order_.begin();
    const bool shown = std::ranges::find(shown_, id) != shown_.end();
    Json json{{"type", "scatter"},           {"name", legend_name(*drawn.solution)},
              {"legendgroup", id},           {"legendrank", rank},
              {"showlegend", false},         {"x", "@" + x_of(drawn)},
              {"y", "@" + id + " " + array}, {"xaxis", axis('x', row)},
              {"yaxis", axis('y', row)}};
    if (!shown) json["visible"] = "legendonly";
    return json;
  }

  void add_curve(const DrawnCurve& drawn, Row row, const std::string& array) {
    Json json = trace(drawn, row, array);
    json["showlegend"] = row == kLinear;
    if (drawn.style.as_points) {
      json["mode"] = "markers";
      // More points than these would hide the lines.
      json["marker"] = {{"color", drawn.style.colour},
                        {"symbol", "circle-open"},
                        {"size", 6},
                        {"maxdisplayed", 40}};
    } else {
      json["mode"] = "lines";
      json["line"] = line_of(drawn.style);
    }
    json["hovertemplate"] = "%{y:.4g}";
    traces_.push_back(json);
  }

  void add_bands(const DrawnCurve& drawn) {
    const MarginalCurve& curve = *drawn.curve;
    if (curve.lower.empty() || curve.upper.empty()) return;
    const std::string& id = curve.solution;
    put(id + " lower", curve.lower);
    put(id + " upper", curve.upper);
    add_band(drawn, kLinear, "lower", "upper");
    put(id + " positive lower", at_least(curve.lower, kFarBelow));
    put(id + " positive upper", at_least(curve.upper, kFarBelow));
    add_band(drawn, kLogarithmic, "positive lower", "positive upper");
    if (drawn.difference.empty()) return;
    put(id + " difference lower", plus(drawn.difference, minus(curve.lower, curve.density)));
    put(id + " difference upper", plus(drawn.difference, minus(curve.upper, curve.density)));
    add_band(drawn, kDifference, "difference lower", "difference upper");
  }

  void add_band(const DrawnCurve& drawn, Row row, const std::string& lower,
                const std::string& upper) {
    Json from = trace(drawn, row, lower), to = trace(drawn, row, upper);
    for (Json* edge : {&from, &to}) {
      (*edge)["mode"] = "lines";
      (*edge)["line"] = {{"width", 0}};
      (*edge)["hoverinfo"] = "skip";
    }
    to["fill"] = "tonexty";
    to["fillcolor"] = "rgba(0,0,0,0.18)";
    traces_.push_back(from);
    traces_.push_back(to);
  }

  Json layout() const {
    const FigureRanges& r = side_.ranges;
    const std::string y = variable_text(side_.variable), p = "p(" + y + ")";
    const bool with_difference = !reference_.empty();
    const double gap = 0.07;
    const double rows = with_difference ? 3 : 2;
    const auto domain = [&](Row row) {
      const double height = (1 - (rows - 1) * gap) / rows,
                   top = 1 - static_cast<int>(row) * (height + gap);
      return Json{std::max(0.0, top - height), top};
    };
    const auto x_axis = [&](Row row, double from, double to) {
      return Json{{"anchor", axis('y', row)}, {"range", {from, to}}, {"title", {{"text", ""}}}};
    };
    Json json{{"xaxis", x_axis(kLinear, r.linear_from, r.linear_to)},
              {"yaxis",
               {{"domain", domain(kLinear)},
                {"anchor", "x"},
                {"range", {0, 1.08 * r.largest_density}},
                {"title", {{"text", p}}}}},
              {"xaxis2", x_axis(kLogarithmic, r.logarithmic_from, r.logarithmic_to)},
              {"yaxis2",
               {{"domain", domain(kLogarithmic)},
                {"anchor", "x2"},
                {"type", "log"},
                {"dtick", 1},
                {"exponentformat", "power"},
                {"range", {std::log10(kSmallestShown), std::log10(3 * r.largest_density)}},
                {"title", {{"text", p + ", logarithmic"}}}}}};
    if (with_difference) {
      json["xaxis3"] = x_axis(kDifference, r.linear_from, r.linear_to);
      json["yaxis3"] = {{"domain", domain(kDifference)},
                        {"anchor", "x3"},
                        {"exponentformat", "power"},
                        {"title", {{"text", p + " \u2212 " + reference_}}}};
    }
    json[with_difference ? "xaxis3" : "xaxis2"]["title"] = {{"text", y}};
    return json;
  }

  const FigureSide& side_;
  std::string reference_;
  std::vector<std::string> shown_, order_;
  Json arrays_ = Json::object(), traces_ = Json::array();
};

}  // namespace

std::vector<Plot> density_plots(const Json& summary_case, std::span<const MarginalCurve> curves,
                                const std::string& prefix) {
  const FigureContent content = figure_content(summary_case, curves);
  std::vector<Plot> plots;
  for (const auto& side : content.sides) {
    const std::string caption = fmt::format(
        "{} {}: density, its logarithm{}", side.variable == "y" ? "Displacement" : "Velocity",
        variable_text(side.variable),
        content.reference.empty() ? "" : ", difference from " + content.reference);
    plots.push_back({prefix + "-density-" + side.variable, caption,
                     DensityPlot(summary_case, side, content.reference).figure()});
  }
  return plots;
}

}  // namespace fpkcheck::compare
