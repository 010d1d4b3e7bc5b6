#include "report/page/density_plots.hpp"
#include "report/figure/script_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "report/figure/content.hpp"
#include "report/page/html.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSmallestShown = 1e-7;
// The value that replaces ends of confidence intervals at or below zero, which have no logarithm.
// The value lies far below the axis.
constexpr double kBelowAxis = 1e-12;

/// The rows of a density plot from bottom to top, with the axes "", "2" and "3" of plotly.js. The
/// differences are in the top row, since the densities nearly coincide.
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
  /// @param shown ids of the solutions that are initially visible
  DensityPlot(const results::CaseResult& case_result, const MarginalCurves& marginal,
              const FigureContent& content, const std::set<std::string>& shown)
      : case_result_(case_result),
        marginal_(marginal),
        reference_(content.reference),
        smooth_(content.smooth_differences),
        shown_(shown) {
    for (const auto& drawn : marginal_.curves) add(drawn);
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
    if (abscissa_name(drawn) == solution + " x") store_array(solution + " x", abscissa);
    store_array(solution + " p", density);
    const bool has_bands = !lower.empty() && !upper.empty();
    if (has_bands) {
      add_band(drawn, kLinear, "p", lower, upper);
      add_band(drawn, kLogarithmic, "log p", at_least(lower, kBelowAxis),
               at_least(upper, kBelowAxis));
    }
    add_curve(drawn, kLinear, "p");
    add_curve(drawn, kLogarithmic, "p");
    if (drawn.difference.empty()) return;
    const CurveDifference& difference = drawn.difference;
    if (difference_abscissa_name(drawn) == solution + " difference x") {
      store_array(solution + " difference x", difference.abscissa);
    }
    store_array(solution + " difference", difference.values);
    if (!difference.lower.empty()) {
      add_band(drawn, kDifference, "difference", difference.lower, difference.upper);
    }
    add_curve(drawn, kDifference, "difference");
  }

  // The name of the array with the abscissae of a curve. Curves with the same bins as the first
  // curve share the array of the first curve.
  std::string abscissa_name(const DrawnCurve& drawn) const {
    const results::Curve& first = *marginal_.curves.front().curve;
    const bool same = drawn.curve->abscissa == first.abscissa;
    return (same ? first.solution : drawn.curve->solution) + " x";
  }

  // The name of the array with the abscissae of a difference. Differences with the same bins as the
  // first difference share the array of the first difference.
  std::string difference_abscissa_name(const DrawnCurve& drawn) const {
    const DrawnCurve& first = marginal_.curves.front();
    const bool same = drawn.difference.abscissa == first.difference.abscissa;
    return (same ? first : drawn).curve->solution + " difference x";
  }

  void store_array(const std::string& name, const std::vector<double>& values) {
    arrays_[name] = float_array(values);
  }

  Json trace(const DrawnCurve& drawn, Row row, const std::string& array) const {
    const std::string& id = drawn.curve->solution;
    const std::string x =
        row == kDifference ? difference_abscissa_name(drawn) : abscissa_name(drawn);
    // The entries of the legend have the order of the tables, not the order in which curves are
    // drawn.
    const auto rank = drawn.solution - case_result_.solutions.data();
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
    const auto& plot_style = drawn.solution->identity.plot_style;
    if (plot_style.as_points) {
      json["mode"] = "markers";
      // A curve drawn as points has at most about 40 points, since more points would hide the lines
      // of other curves.
      json["marker"] = {{"color", plot_style.colour},
                        {"symbol", "circle-open"},
                        {"size", 6},
                        {"maxdisplayed", 40}};
    } else {
      json["mode"] = "lines";
      json["line"] = {{"color", plot_style.colour},
                      {"width", plot_style.width},
                      {"dash", plotly_dash(plot_style.dash)}};
    }
    json["hovertemplate"] = "%{y:.4g}";
    traces_.push_back(json);
  }

  void add_band(const DrawnCurve& drawn, Row row, const std::string& array,
                const std::vector<double>& lower, const std::vector<double>& upper) {
    store_array(drawn.curve->solution + ' ' + array + " lower", lower);
    store_array(drawn.curve->solution + ' ' + array + " upper", upper);
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
    const MarginalAxisRanges& r = marginal_.ranges;
    const std::string p = density_text(marginal_.variable);
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
    Json json{{"xaxis", x_axis(kLinear, r.linear_from, r.linear_to)},
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
                 {std::log10(logarithmic_axis_bottom(r, kSmallestShown)),
                  std::log10(logarithmic_axis_top(r))}},
                {"title", {{"text", p + ", logarithmic"}}}}}};
    if (const std::string beyond = spike_note(r); !beyond.empty()) {
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
        const auto [from, to] = difference_axis_decades(visible_ranges());
        json["yaxis3"]["type"] = "log";
        json["yaxis3"]["dtick"] = 1;
        json["yaxis3"]["range"] = {std::log10(from), std::log10(to)};
        json["yaxis3"]["title"]["text"] = fmt::format("|{} \u2212 {}|", p, plotly_text(reference_));
      }
    }
    json["xaxis"]["title"] = {{"text", variable_text(marginal_.variable)}};
    return json;
  }

  // The axis range of the differences, which ignores initially hidden curves.
  MarginalAxisRanges visible_ranges() const {
    std::vector<DrawnCurve> curves;
    std::ranges::copy_if(
        marginal_.curves, std::back_inserter(curves),
        [&](const DrawnCurve& drawn) { return shown_.contains(drawn.curve->solution); });
    return curves.empty() ? marginal_.ranges : difference_axis_ranges(curves, smooth_);
  }

  const results::CaseResult& case_result_;
  const MarginalCurves& marginal_;
  const std::string& reference_;  // id, or "" without reference
  bool smooth_;                   // differences between averages over smooth bins
  const std::set<std::string>& shown_;
  Json arrays_ = Json::object(), traces_ = Json::array();
};

}  // namespace

std::set<std::string> initially_visible_solutions(const results::CaseResult& case_result) {
  std::set<std::string> ids, families;
  for (const auto* closure : case_result.assessment.ranked_closures()) {
    const auto& family = case_result.find(closure->id)->identity.family;
    if (families.insert(family).second) ids.insert(closure->id);
  }
  for (const auto* solution : references(case_result)) ids.insert(solution->id());
  for (const auto& solution : case_result.solutions) {
    if (transform::is_external(solution.identity)) ids.insert(solution.id());
  }
  if (ids.size() < 2) {
    for (const auto& solution : case_result.solutions) ids.insert(solution.id());
  }
  return ids;
}

std::vector<Plot> density_plots(const results::CaseResult& case_result,
                                const FigureContent& content, const std::set<std::string>& shown,
                                const std::string& prefix) {
  std::vector<Plot> plots;
  for (const auto& marginal : content.marginals) {
    std::string caption(base::meaning_of(marginal.variable));
    caption.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(caption.front())));
    caption += fmt::format(" {}: ", variable_text(marginal.variable));
    if (!content.reference.empty()) {
      caption += "difference from " + content.reference;
      if (content.smooth_differences) {
        caption += " over smooth bins, with the half-width of its 95 % confidence intervals";
      }
      caption += "; ";
    }
    caption += "logarithm of the density; density";
    plots.push_back({fmt::format("{}-density-{}", prefix, name(marginal.variable)), caption,
                     DensityPlot(case_result, marginal, content, shown).figure()});
  }
  return plots;
}

std::vector<Plot> density_plots(const results::CaseResult& case_result, const std::string& prefix) {
  return density_plots(case_result, figure_content(case_result),
                       initially_visible_solutions(case_result), prefix);
}

}  // namespace fpkcheck::report
