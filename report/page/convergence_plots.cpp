#include "report/page/convergence_plots.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "compare/reference.hpp"
#include "report/convergence_over_order.hpp"
#include "report/families.hpp"
#include "report/page/log_range.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using transform::Solution;
using transform::Variable;

// The properties that the plotly.js traces of order plots and cost plots share. Solutions that are
// not ok have open marks.
template <class L1>
Json base_trace(const SolutionFamily& family, const L1& l1, LogAxisRange& range) {
  Json l1s = Json::array(), names = Json::array(), symbols = Json::array(), colours = Json::array();
  for (const Solution* solution : family.solutions) {
    l1s.push_back(l1(*solution));
    range.include(l1(*solution));
    names.push_back(legend_name(*solution));
    colours.push_back(solution->identity.plot_style.colour);
    symbols.push_back(solution->identity.plot_style.symbol + (solution->is_ok() ? "" : "-open"));
  }
  return {{"type", "scatter"},
          {"name", plotly_text(family.name)},
          {"legendgroup", "family " + family.name},
          {"y", l1s},
          {"customdata", names},
          {"marker", {{"color", colours}, {"symbol", symbols}, {"size", 9}}}};
}

Json log_axis(const std::string& title, const LogAxisRange& range) {
  // The axis range leaves space for marks and names at both ends.
  return {{"type", "log"},
          {"range", range.exponents(0.3, 0.4)},
          {"exponentformat", "power"},
          {"dtick", 1},
          {"automargin", true},
          {"title", {{"text", title}}}};
}

std::string figure(const Json& data, const Json& x_axis, Variable variable,
                   const Solution& reference, const LogAxisRange& l1s) {
  const std::string y_title =
      fmt::format("L1 distance of {} to {}", density_text(variable), plotly_text(reference.id()));
  const Json json{
      {"height", 340},
      {"arrays", Json::object()},
      {"data", data},
      {"layout", {{"hovermode", "closest"}, {"xaxis", x_axis}, {"yaxis", log_axis(y_title, l1s)}}}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// A plotly.js trace of a horizontal line across the plot.
Json horizontal_line_trace(const std::string& name, double l1, const Json& line, double from,
                           double to) {
  return {{"type", "scatter"},
          {"mode", "lines"},
          {"name", plotly_text(name)},
          {"legendgroup", "level " + name},
          {"x", {from, to}},
          {"y", {l1, l1}},
          {"line", line},
          {"hovertemplate", "%{y:.3g}"}};
}

/// The plotly.js trace of an external density: a mark at the order of the density, or a horizontal
/// line if the density has no order.
Json external_density_trace(const Solution& external_density, double l1, double from, double to) {
  const auto& plot_style = external_density.identity.plot_style;
  Json trace = horizontal_line_trace(
      legend_name(external_density), l1,
      {{"color", plot_style.colour}, {"width", 2}, {"dash", "longdash"}}, from, to);
  if (!external_density.identity.order) return trace;
  trace["mode"] = "markers";
  trace["x"] = {*external_density.identity.order};
  trace["y"] = {l1};
  trace["marker"] = {{"color", plot_style.colour},
                     {"symbol", external_density.is_ok() ? "star" : "star-open"},
                     {"size", 13}};
  trace.erase("line");
  return trace;
}

std::string order_figure(const ConvergenceOverOrder& distances) {
  Json data = Json::array();
  LogAxisRange l1s;
  const auto l1_of = [&](const Solution& solution) { return distances.l1(solution); };
  for (const auto& family : distances.families) {
    Json trace = base_trace(family, l1_of, l1s), orders = Json::array();
    for (const Solution* solution : family.solutions) orders.push_back(*solution->identity.order);
    const Solution& middle = *family.solutions[family.solutions.size() / 2];
    trace["x"] = orders;
    trace["mode"] = "lines+markers";
    trace["line"] = {{"color", middle.identity.plot_style.colour}, {"width", 1.5}};
    trace["hovertemplate"] = "%{customdata}: %{y:.3g}<extra></extra>";
    data.push_back(trace);
  }
  const auto [first, last] = distances.order_range();
  const double from = first - 0.5, to = last + 0.5;
  for (const Solution* external_density : distances.external_densities) {
    const double l1 = distances.l1(*external_density);
    l1s.include(l1);
    data.push_back(external_density_trace(*external_density, l1, from, to));
  }
  for (const auto& [name, l1, dash] : distances.uncertainty_lines) {
    l1s.include(l1);
    const Json line{{"color", "#555555"}, {"width", 1.5}, {"dash", dash}};
    data.push_back(horizontal_line_trace(name, l1, line, from, to));
  }
  const Json x_axis{{"range", {from, to}},
                    {"dtick", 2},
                    {"tick0", 0},
                    {"title", {{"text", "order n of the closure"}}}};
  return figure(data, x_axis, distances.variable, *distances.reference, l1s);
}

// The position of the name beside a mark. The position differs between neighbouring marks of a
// family and between families, so that fewer names overlap.
const char* text_position(std::size_t place_of_family, std::size_t place_in_it) {
  constexpr std::array kSides{"top center", "bottom center", "top left", "bottom right"};
  return kSides[(place_of_family + place_in_it) % kSides.size()];
}

std::string cost_figure(const std::vector<SolutionFamily>& compared,
                        const results::CaseResult& case_result, const Solution& reference,
                        Variable variable) {
  Json data = Json::array();
  LogAxisRange times, l1s;
  const auto l1_of = [&](const Solution& solution) {
    return case_result.l1(solution.id(), reference.id(), variable).value_or(0);
  };
  for (const auto& family : compared) {
    Json trace = base_trace(family, l1_of, l1s), seconds = Json::array(), labels = Json::array(),
         positions = Json::array();
    for (const Solution* solution : family.solutions) {
      const double taken = solution->seconds;
      seconds.push_back(taken > 0 ? Json(taken) : Json());
      times.include(taken);
      positions.push_back(text_position(data.size(), labels.size()));
      labels.push_back(plotly_text(transform::short_name(solution->identity)));
    }
    trace["x"] = seconds;
    trace["mode"] = "markers+text";
    trace["text"] = labels;
    trace["textposition"] = positions;
    trace["textfont"] = {{"size", 10}};
    trace["cliponaxis"] = false;
    trace["hovertemplate"] = "%{customdata}: %{y:.3g} in %{x:.2g} s<extra></extra>";
    data.push_back(trace);
  }
  return figure(data, log_axis("computing time in seconds", times), variable, reference, l1s);
}

}  // namespace

std::vector<Plot> order_plots(const results::CaseResult& case_result, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const Variable variable : transform::kVariables) {
    const auto distances = convergence_over_order(case_result, variable);
    if (!distances) continue;
    plots.push_back({fmt::format("{}-order-{}", prefix, name(variable)),
                     fmt::format("Convergence of the closures in {}; open marks: not ok",
                                 density_text(variable)),
                     order_figure(*distances)});
  }
  return plots;
}

std::vector<Plot> cost_plots(const results::CaseResult& case_result, const std::string& prefix) {
  std::vector<Plot> plots;
  const Solution* reference = compare::select_reference(case_result.solutions);
  if (reference == nullptr) return plots;
  for (const Variable variable : transform::kVariables) {
    std::vector<const Solution*> compared;
    for (const auto& solution : case_result.solutions) {
      if (case_result.l1(solution.id(), reference->id(), variable).value_or(0) > 0)
        compared.push_back(&solution);
    }
    if (compared.empty()) continue;
    plots.push_back(
        {fmt::format("{}-cost-{}", prefix, name(variable)),
         fmt::format("L1 distance in {} against computing time", density_text(variable)),
         cost_figure(group_by_family(compared), case_result, *reference, variable)});
  }
  return plots;
}

}  // namespace fpkcheck::report
