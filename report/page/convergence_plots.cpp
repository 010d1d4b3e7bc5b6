#include "report/page/convergence_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/reference.hpp"
#include "report/page/families.hpp"
#include "report/page/log_range.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using transform::Solution;
using transform::Variable;

/// L1 to the reference in one variable.
struct Distances {
  const results::Case& one;
  const Solution& reference;
  Variable variable;

  double of(const Solution& solution) const {
    return one.l1(solution.id(), reference.id(), variable).value_or(0);
  }
  /// The families of those solutions that are away from the reference.
  std::vector<Family> families() const {
    std::vector<const Solution*> away;
    for (const auto& solution : one.solutions) {
      if (of(solution) > 0) away.push_back(&solution);
    }
    return report::families(away);
  }
};

bool has_orders(const Family& family) {
  return std::ranges::all_of(family.solutions, [](const Solution* solution) {
    const auto& identity = solution->identity;
    return identity.role == transform::Role::closure && identity.order &&
           !transform::is_guest(identity);
  });
}

// What both plots share. Solutions that are not ok are hollow.
Json base_trace(const Family& family, const Distances& distances, LogRange& range) {
  Json l1s = Json::array(), names = Json::array(), symbols = Json::array(), colours = Json::array();
  for (const Solution* solution : family.solutions) {
    l1s.push_back(distances.of(*solution));
    range.include(distances.of(*solution));
    names.push_back(legend_name(*solution));
    colours.push_back(solution->identity.look.colour);
    symbols.push_back(solution->identity.look.symbol + (solution->is_ok() ? "" : "-open"));
  }
  return {{"type", "scatter"},
          {"name", plotly_text(family.name)},
          {"legendgroup", "family " + family.name},
          {"y", l1s},
          {"customdata", names},
          {"marker", {{"color", colours}, {"symbol", symbols}, {"size", 9}}}};
}

Json log_axis(const std::string& title, const LogRange& range) {
  // With room for marks and their names at both ends.
  return {{"type", "log"},
          {"range", range.exponents(0.3, 0.4)},
          {"exponentformat", "power"},
          {"dtick", 1},
          {"automargin", true},
          {"title", {{"text", title}}}};
}

std::string figure(const Json& data, const Json& x_axis, const Distances& distances,
                   const LogRange& l1s) {
  const std::string y_title = fmt::format("L1 of {} to {}", density_text(distances.variable),
                                          plotly_text(distances.reference.id()));
  const Json json{
      {"height", 340},
      {"arrays", Json::object()},
      {"data", data},
      {"layout", {{"hovermode", "closest"}, {"xaxis", x_axis}, {"yaxis", log_axis(y_title, l1s)}}}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// How well the reference itself is known: how far others of the same problem are from it, and its
/// own account.
struct Level {
  std::string name;
  double l1;
  const char* dash;
};

std::vector<Level> levels(const Distances& distances) {
  const auto& [one, reference, variable] = distances;
  std::vector<Level> all;
  for (const Solution* other : references(one)) {
    const double l1 = distances.of(*other);
    if (l1 > 0) all.push_back({fmt::format("{} to {}", other->id(), reference.id()), l1, "dot"});
  }
  const double own = compare::own_error(reference, variable);
  if (std::isfinite(own) && own > 0) {
    all.push_back({"error of " + reference.id() + ", by its own account", own, "dash"});
  }
  return all;
}

/// A horizontal line across the plot.
Json level_trace(const std::string& name, double l1, const Json& line, double from, double to) {
  return {{"type", "scatter"},
          {"mode", "lines"},
          {"name", plotly_text(name)},
          {"legendgroup", "level " + name},
          {"x", {from, to}},
          {"y", {l1, l1}},
          {"line", line},
          {"hovertemplate", "%{y:.3g}"}};
}

/// What somebody brought along, away from the reference.
std::vector<const Solution*> guests(const Distances& distances) {
  std::vector<const Solution*> found;
  for (const auto& solution : distances.one.solutions) {
    if (transform::is_guest(solution.identity) && distances.of(solution) > 0) {
      found.push_back(&solution);
    }
  }
  return found;
}

/// A guest at its order, or as a level where it has none.
Json guest_trace(const Solution& guest, double l1, double from, double to) {
  const auto& look = guest.identity.look;
  Json trace = level_trace(legend_name(guest), l1,
                           {{"color", look.colour}, {"width", 2}, {"dash", "longdash"}}, from, to);
  if (!guest.identity.order) return trace;
  trace["mode"] = "markers";
  trace["x"] = {*guest.identity.order};
  trace["y"] = {l1};
  trace["marker"] = {
      {"color", look.colour}, {"symbol", guest.is_ok() ? "star" : "star-open"}, {"size", 13}};
  trace.erase("line");
  return trace;
}

std::string order_figure(const Distances& distances) {
  Json data = Json::array();
  double first = 1e9, last = 0;
  LogRange l1s;
  for (const auto& family : distances.families()) {
    if (!has_orders(family)) continue;
    Json trace = base_trace(family, distances, l1s), orders = Json::array();
    for (const Solution* solution : family.solutions) {
      const int order = *solution->identity.order;
      orders.push_back(order);
      first = std::min<double>(first, order);
      last = std::max<double>(last, order);
    }
    const Solution& middle = *family.solutions[family.solutions.size() / 2];
    trace["x"] = orders;
    trace["mode"] = "lines+markers";
    trace["line"] = {{"color", middle.identity.look.colour}, {"width", 1.5}};
    trace["hovertemplate"] = "%{customdata}: %{y:.3g}<extra></extra>";
    data.push_back(trace);
  }
  const auto brought_along = guests(distances);
  for (const Solution* guest : brought_along) {
    if (!guest->identity.order) continue;
    first = std::min<double>(first, *guest->identity.order);
    last = std::max<double>(last, *guest->identity.order);
  }
  for (const Solution* guest : brought_along) {
    const double l1 = distances.of(*guest);
    l1s.include(l1);
    data.push_back(guest_trace(*guest, l1, first - 0.5, last + 0.5));
  }
  for (const auto& [name, l1, dash] : levels(distances)) {
    l1s.include(l1);
    const Json line{{"color", "#555555"}, {"width", 1.5}, {"dash", dash}};
    data.push_back(level_trace(name, l1, line, first - 0.5, last + 0.5));
  }
  const Json x_axis{{"range", {first - 0.5, last + 0.5}},
                    {"dtick", 2},
                    {"tick0", 0},
                    {"title", {{"text", "order n of the closure"}}}};
  return figure(data, x_axis, distances, l1s);
}

// The side of a mark on which its name stands: neighbours, in a family and between families, have
// different ones, so that fewer names fall upon each other.
const char* text_position(std::size_t place_of_family, std::size_t place_in_it) {
  constexpr std::array kSides{"top center", "bottom center", "top left", "bottom right"};
  return kSides[(place_of_family + place_in_it) % kSides.size()];
}

std::string cost_figure(const Distances& distances) {
  Json data = Json::array();
  LogRange times, l1s;
  for (const auto& family : distances.families()) {
    Json trace = base_trace(family, distances, l1s), seconds = Json::array(),
         labels = Json::array(), positions = Json::array();
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
  return figure(data, log_axis("seconds", times), distances, l1s);
}

// A plot for each variable in which there is something to draw.
std::vector<Plot> plots_of(const results::Case& one, const std::string& prefix, const char* caption,
                           bool (*is_drawn)(const Family&),
                           std::string (*figure_of)(const Distances&)) {
  std::vector<Plot> plots;
  const Solution* reference = compare::reference(one.solutions);
  if (reference == nullptr) return plots;
  for (const Variable variable : transform::kVariables) {
    const Distances distances{one, *reference, variable};
    if (!std::ranges::any_of(distances.families(), is_drawn)) continue;
    plots.push_back({fmt::format("{}-{}", prefix, name(variable)),
                     fmt::format(fmt::runtime(caption), density_text(variable)),
                     figure_of(distances)});
  }
  return plots;
}

}  // namespace

std::vector<Plot> order_plots(const results::Case& one, const std::string& prefix) {
  const auto is_drawn = [](const Family& family) {
    return family.solutions.size() > 1 && has_orders(family);
  };
  return plots_of(one, prefix + "-order", "Convergence of the closures in {}; hollow: not ok",
                  is_drawn, order_figure);
}

std::vector<Plot> cost_plots(const results::Case& one, const std::string& prefix) {
  const auto is_drawn = [](const Family&) { return true; };
  return plots_of(one, prefix + "-cost", "Distance in {} against cost", is_drawn, cost_figure);
}

}  // namespace fpkcheck::report
