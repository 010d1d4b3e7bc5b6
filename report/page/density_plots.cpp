#include "report/page/density_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "report/figure/content.hpp"
#include "report/page/first_shown.hpp"
#include "report/page/typed_array.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSmallestShown = 1e-7;
// Replaces ends of intervals at or below zero, which have no logarithm; far below the axis.
constexpr double kFarBelow = 1e-12;

/// The rows of a plot, axes "", "2", "3" of plotly.js, from the bottom. The differences are at the
/// top, since the densities nearly coincide.
enum Row { kLinear, kLogarithmic, kDifference };

std::string axis(char letter, Row row) {
  return row == kLinear ? std::string(1, letter) : fmt::format("{}{}", letter, row + 1);
}

std::vector<double> at_least(std::vector<double> values, double least) {
  for (double& value : values) value = std::max(value, least);
  return values;
}

class DensityPlot {
 public:
  /// @param shown ids of the initially visible solutions
  DensityPlot(const results::Case& one, const FigureSide& side, const FigureContent& content,
              const std::set<std::string>& shown)
      : one_(one),
        side_(side),
        reference_(content.reference),
        smooth_(content.smooth_differences),
        shown_(shown) {
    for (const auto& drawn : side_.curves) add(drawn);
  }

  std::string figure() const {
    const Json json{{"height", reference_.empty() ? 520 : 760},
                    {"arrays", arrays_},
                    {"data", traces_},
                    {"layout", layout()}};
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }

 private:
  void add(const DrawnCurve& drawn) {
    const results::Curve& curve = *drawn.curve;
    const auto& [solution, variable, abscissa, density, lower, upper] = curve;
    if (x_of(drawn) == solution + " x") put(solution + " x", abscissa);
    put(solution + " p", density);
    const bool has_bands = !lower.empty() && !upper.empty();
    if (has_bands) {
      add_band(drawn, kLinear, "p", lower, upper);
      add_band(drawn, kLogarithmic, "log p", at_least(lower, kFarBelow),
               at_least(upper, kFarBelow));
    }
    add_curve(drawn, kLinear, "p");
    add_curve(drawn, kLogarithmic, "p");
    if (drawn.difference.empty()) return;
    const Difference& difference = drawn.difference;
    if (difference_x_of(drawn) == solution + " difference x") {
      put(solution + " difference x", difference.abscissa);
    }
    put(solution + " difference", difference.values);
    if (!difference.lower.empty()) {
      add_band(drawn, kDifference, "difference", difference.lower, difference.upper);
    }
    add_curve(drawn, kDifference, "difference");
  }

  // Name of the array of abscissae. Curves on the bins of the first curve share its array.
  std::string x_of(const DrawnCurve& drawn) const {
    const results::Curve& first = *side_.curves.front().curve;
    const bool same = drawn.curve->abscissa == first.abscissa;
    return (same ? first.solution : drawn.curve->solution) + " x";
  }

  // Name of the array of abscissae of a difference. Differences on the bins of the first curve's
  // difference share its array.
  std::string difference_x_of(const DrawnCurve& drawn) const {
    const DrawnCurve& first = side_.curves.front();
    const bool same = drawn.difference.abscissa == first.difference.abscissa;
    return (same ? first : drawn).curve->solution + " difference x";
  }

  void put(const std::string& name, const std::vector<double>& values) {
    arrays_[name] = float_array(values);
  }

  Json trace(const DrawnCurve& drawn, Row row, const std::string& array) const {
    const std::string& id = drawn.curve->solution;
    const std::string x = row == kDifference ? difference_x_of(drawn) : x_of(drawn);
    // Legends have the order of the tables, not the drawing order.
    const auto rank = drawn.solution - one_.solutions.data();
    Json json{{"type", "scatter"},           {"name", legend_name(*drawn.solution)},
              {"legendgroup", id},           {"legendrank", rank},
              {"showlegend", false},         {"x", "@" + x},
              {"y", "@" + id + " " + array}, {"xaxis", axis('x', row)},
              {"yaxis", axis('y', row)}};
    if (!shown_.contains(id)) json["visible"] = "legendonly";
    return json;
  }

  void add_curve(const DrawnCurve& drawn, Row row, const std::string& array) {
    Json json = trace(drawn, row, array);
    json["showlegend"] = row == kLinear;
    const auto& look = drawn.solution->identity.look;
    if (look.as_points) {
      json["mode"] = "markers";
      // More than 40 points would hide the lines.
      json["marker"] = {
          {"color", look.colour}, {"symbol", "circle-open"}, {"size", 6}, {"maxdisplayed", 40}};
    } else {
      json["mode"] = "lines";
      json["line"] = {
          {"color", look.colour}, {"width", look.width}, {"dash", plotly_dash(look.dash)}};
    }
    json["hovertemplate"] = "%{y:.4g}";
    traces_.push_back(json);
  }

  void add_band(const DrawnCurve& drawn, Row row, const std::string& array,
                const std::vector<double>& lower, const std::vector<double>& upper) {
    put(drawn.curve->solution + ' ' + array + " lower", lower);
    put(drawn.curve->solution + ' ' + array + " upper", upper);
    Json from = trace(drawn, row, array + " lower"), to = trace(drawn, row, array + " upper");
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
    const std::string p = density_text(side_.variable);
    const bool with_difference = !reference_.empty();
    const double gap = 0.07;
    const double rows = with_difference ? 3 : 2;
    const auto domain = [&](Row row) {
      const double height = (1 - (rows - 1) * gap) / rows,
                   bottom = static_cast<int>(row) * (height + gap);
      return Json{bottom, std::min(1.0, bottom + height)};
    };
    const auto x_axis = [&](Row row, double from, double to) {
      return Json{{"anchor", axis('y', row)}, {"range", {from, to}}, {"title", {{"text", ""}}}};
    };
    Json json{
        {"xaxis", x_axis(kLinear, r.linear_from, r.linear_to)},
        {"yaxis",
         {{"domain", domain(kLinear)},
          {"anchor", "x"},
          {"range", {0, 1.08 * r.linear_top}},
          {"title", {{"text", p}}}}},
        {"xaxis2", x_axis(kLogarithmic, r.logarithmic_from, r.logarithmic_to)},
        {"yaxis2",
         {{"domain", domain(kLogarithmic)},
          {"anchor", "x2"},
          {"type", "log"},
          {"dtick", 1},
          {"exponentformat", "power"},
          {"range",
           {std::log10(logarithmic_bottom(r, kSmallestShown)), std::log10(logarithmic_top(r))}},
          {"title", {{"text", p + ", logarithmic"}}}}}};
    if (const std::string beyond = beyond_the_top(r); !beyond.empty()) {
      json["annotations"] = Json::array({{{"xref", "x"},
                                          {"yref", "y domain"},
                                          {"x", 0},
                                          {"y", 0.97},
                                          {"xanchor", "left"},
                                          {"xshift", 8},
                                          {"showarrow", false},
                                          {"text", beyond}}});
    }
    if (with_difference) {
      json["xaxis3"] = x_axis(kDifference, r.linear_from, r.linear_to);
      json["yaxis3"] = {{"domain", domain(kDifference)},
                        {"anchor", "x3"},
                        {"exponentformat", "power"},
                        {"title", {{"text", p + " \u2212 " + plotly_text(reference_)}}}};
      if (smooth_) {
        const auto [from, to] = difference_decades(ranges_of_shown());
        json["yaxis3"]["type"] = "log";
        json["yaxis3"]["dtick"] = 1;
        json["yaxis3"]["range"] = {std::log10(from), std::log10(to)};
        json["yaxis3"]["title"]["text"] = fmt::format("|{} \u2212 {}|", p, plotly_text(reference_));
      }
    }
    json["xaxis"]["title"] = {{"text", variable_text(side_.variable)}};
    return json;
  }

  // The range of the axis of differences: initially hidden curves do not affect it.
  FigureRanges ranges_of_shown() const {
    std::vector<DrawnCurve> curves;
    std::ranges::copy_if(side_.curves, std::back_inserter(curves), [&](const DrawnCurve& drawn) {
      return shown_.contains(drawn.curve->solution);
    });
    return curves.empty() ? side_.ranges : difference_ranges(curves, smooth_);
  }

  const results::Case& one_;
  const FigureSide& side_;
  const std::string& reference_;  // id, or "" without reference
  bool smooth_;                   // differences between averages over smooth bins
  const std::set<std::string>& shown_;
  Json arrays_ = Json::object(), traces_ = Json::array();
};

}  // namespace

std::vector<Plot> density_plots(const results::Case& one, const FigureContent& content,
                                const std::set<std::string>& shown, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const auto& side : content.sides) {
    std::string caption(base::meaning_of(side.variable));
    caption.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(caption.front())));
    caption += fmt::format(" {}: ", variable_text(side.variable));
    if (!content.reference.empty()) {
      caption += "difference from " + content.reference;
      if (content.smooth_differences) {
        caption += " over smooth bins, with the half-width of its 95 % confidence intervals";
      }
      caption += "; ";
    }
    caption += "logarithm of the density; density";
    plots.push_back({fmt::format("{}-density-{}", prefix, name(side.variable)), caption,
                     DensityPlot(one, side, content, shown).figure()});
  }
  return plots;
}

std::vector<Plot> density_plots(const results::Case& one, const std::string& prefix) {
  return density_plots(one, figure_content(one), first_shown(one), prefix);
}

}  // namespace fpkcheck::report
