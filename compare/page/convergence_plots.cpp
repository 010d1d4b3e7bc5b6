#include "compare/page/convergence_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "compare/page/closest.hpp"
#include "compare/page/number_text.hpp"
#include "compare/page/trace_style.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;
using transform::Variable;

constexpr Variable kVariables[] = {Variable::y, Variable::ydot};

std::string name_of(Variable variable) { return std::string(transform::name(variable)); }

/// A solution as a point of these plots.
struct Point {
  const Json* solution;
  double l1;
};

std::optional<double> positive(const std::optional<double>& value) {
  return value && *value > 0 ? value : std::nullopt;
}

/// The solutions by formulation ("gaussian", ..), or by method where they have none ("fd", "mcs"),
/// in their own order.
std::vector<std::pair<std::string, std::vector<Point>>> families(const Json& summary_case,
                                                                 Variable variable) {
  std::vector<std::pair<std::string, std::vector<Point>>> result;
  const std::string reference = reference_of(summary_case);
  for (const auto& solution : summary_case.at("solutions")) {
    const auto l1 = positive(
        l1_between(summary_case, solution.at("id").get<std::string>(), reference, variable));
    if (!l1) continue;
    const std::string family =
        solution.value("formulation", solution.at("method").get<std::string>());
    auto found = std::ranges::find(result, family, [](const auto& one) { return one.first; });
    if (found == result.end()) found = result.insert(result.end(), {family, {}});
    found->second.push_back({&solution, *l1});
  }
  return result;
}

const char* symbol_of(const std::string& family) {
  if (family == "gaussian") return "circle";
  if (family == "moment") return "square";
  if (family == "polar") return "diamond";
  if (family == "fd") return "triangle-up";
  return "x";
}

// Solutions that are not ok are hollow.
Json markers(const std::vector<Point>& points, const std::string& family,
             const std::string& colour) {
  Json symbols = Json::array();
  for (const auto& point : points) {
    symbols.push_back(std::string(symbol_of(family)) + (is_ok(*point.solution) ? "" : "-open"));
  }
  return {{"color", colour}, {"symbol", symbols}, {"size", 9}};
}

std::string colour_of(const std::vector<Point>& points) {
  return curve_style(*points[points.size() / 2].solution).colour;
}

Json names(const std::vector<Point>& points) {
  Json list = Json::array();
  for (const auto& point : points) list.push_back(legend_name(*point.solution));
  return list;
}

Json base_trace(const std::string& family, const std::vector<Point>& points) {
  Json y = Json::array();
  for (const auto& point : points) y.push_back(point.l1);
  return {{"type", "scatter"},
          {"name", family},
          {"legendgroup", "family " + family},
          {"y", y},
          {"customdata", names(points)},
          {"marker", markers(points, family, colour_of(points))}};
}

/// Of a logarithmic axis, with room for marks and their names at both ends.
class LogRange {
 public:
  void include(double value) {
    least_ = std::min(least_, value);
    most_ = std::max(most_, value);
  }
  Json exponents() const {
    if (most_ < least_) return {-1, 1};
    return {std::log10(least_) - 0.3, std::log10(most_) + 0.4};
  }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

Json log_axis(const std::string& title, const LogRange& range) {
  return {{"type", "log"}, {"range", range.exponents()}, {"exponentformat", "power"},
          {"dtick", 1},    {"automargin", true},         {"title", {{"text", title}}}};
}

std::string l1_title(const Json& summary_case, Variable variable) {
  return fmt::format("L1 of p({}) to {}", variable_text(name_of(variable)),
                     reference_of(summary_case));
}

/// How well the reference itself is known: its distance from the simulation, its own estimate.
struct Level {
  std::string name;
  double l1;
  const char* dash;
};

std::vector<Level> levels(const Json& summary_case, Variable variable) {
  std::vector<Level> result;
  const std::string reference = reference_of(summary_case);
  const Json* solution = find_solution(summary_case, reference);
  if (solution == nullptr || reference == "mcs") return result;
  if (const auto gap = positive(l1_between(summary_case, reference, "mcs", variable))) {
    result.push_back({"mcs to " + reference, *gap, "dot"});
  }
  if (const auto error = solution->find("error"); error != solution->end()) {
    if (const auto own = positive(number(*error, name_of(variable) + "_l1"))) {
      result.push_back({"error of " + reference + ", estimated", *own, "dash"});
    }
  }
  return result;
}

Json order_figure(const Json& summary_case, Variable variable) {
  Json data = Json::array();
  double first = 1e9, last = 0;
  LogRange l1s;
  for (const auto& [family, points] : families(summary_case, variable)) {
    if (points.front().solution->at("method") != "epc") continue;
    Json trace = base_trace(family, points), orders = Json::array();
    for (const auto& point : points) {
      l1s.include(point.l1);
      const double order = number(*point.solution, "order").value_or(0);
      orders.push_back(order);
      first = std::min(first, order);
      last = std::max(last, order);
    }
    trace["x"] = orders;
    trace["mode"] = "lines+markers";
    trace["line"] = {{"color", colour_of(points)}, {"width", 1.5}};
    trace["hovertemplate"] = "%{customdata}: %{y:.3g}<extra></extra>";
    data.push_back(trace);
  }
  for (const auto& [name, l1, dash] : levels(summary_case, variable)) {
    l1s.include(l1);
    data.push_back({{"type", "scatter"},
                    {"mode", "lines"},
                    {"name", name},
                    {"legendgroup", "level " + name},
                    {"x", {first - 0.5, last + 0.5}},
                    {"y", {l1, l1}},
                    {"line", {{"color", "#555555"}, {"width", 1.5}, {"dash", dash}}},
                    {"hovertemplate", "%{y:.3g}"}});
  }
  return {{"height", 340},
          {"arrays", Json::object()},
          {"data", data},
          {"layout",
           {{"hovermode", "closest"},
            {"xaxis",
             {{"range", {first - 0.5, last + 0.5}},
              {"dtick", 2},
              {"tick0", 0},
              {"title", {{"text", "order n of the closure"}}}}},
            {"yaxis", log_axis(l1_title(summary_case, variable), l1s)}}}};
}

// What tells the members of a family apart.
std::string short_name(const Json& solution) {
  const auto order = number(solution, "order");
  if (solution.at("method") == "epc" && order) return fmt::format("n{:g}", *order);
  const auto id = solution.at("id").get<std::string>();
  return id.substr(id.find('-') + 1);
}

// Beside the mark, on a side of its family's own: fewer names fall upon each other.
const char* text_position(const std::string& family, const std::string& label) {
  if (label.ends_with("-delta")) return "bottom center";  // fd-km4 takes as long
  if (family == "moment") return "top left";
  if (family == "polar") return "bottom right";
  return "top center";
}

Json cost_figure(const Json& summary_case, Variable variable) {
  Json data = Json::array();
  LogRange times, l1s;
  for (const auto& [family, points] : families(summary_case, variable)) {
    Json trace = base_trace(family, points), seconds = Json::array(), labels = Json::array(),
         positions = Json::array();
    for (const auto& point : points) {
      const auto taken = positive(number(*point.solution, "seconds"));
      seconds.push_back(taken ? Json(*taken) : Json());
      if (taken) times.include(*taken);
      l1s.include(point.l1);
      labels.push_back(short_name(*point.solution));
      positions.push_back(text_position(family, short_name(*point.solution)));
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
  return {{"height", 340},
          {"arrays", Json::object()},
          {"data", data},
          {"layout",
           {{"hovermode", "closest"},
            {"xaxis", log_axis("seconds", times)},
            {"yaxis", log_axis(l1_title(summary_case, variable), l1s)}}}};
}

}  // namespace

std::vector<Plot> order_plots(const Json& summary_case, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const Variable variable : kVariables) {
    const auto all = families(summary_case, variable);
    const bool comparable = std::ranges::any_of(all, [](const auto& family) {
      return family.second.size() > 1 && family.second.front().solution->at("method") == "epc";
    });
    if (!comparable) continue;
    const std::string name = name_of(variable);
    plots.push_back({fmt::format("{}-order-{}", prefix, name),
                     fmt::format("Convergence of the closures in p({}); hollow: not admissible",
                                 variable_text(name)),
                     order_figure(summary_case, variable)});
  }
  return plots;
}

std::vector<Plot> cost_plots(const Json& summary_case, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const Variable variable : kVariables) {
    if (families(summary_case, variable).empty()) continue;
    const std::string name = name_of(variable);
    plots.push_back({fmt::format("{}-cost-{}", prefix, name),
                     fmt::format("Distance in p({}) against cost", variable_text(name)),
                     cost_figure(summary_case, variable)});
  }
  return plots;
}

}  // namespace fpkcheck::compare
