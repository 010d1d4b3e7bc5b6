#include "compare/page/budget_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "compare/page/html.hpp"
#include "compare/page/number_text.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

std::vector<Json> entries_of(const Json& summary_case, const std::string& variable) {
  std::vector<Json> entries;
  const auto budget = summary_case.find("budget");
  if (budget == summary_case.end() || !budget->is_array()) return entries;
  for (const auto& entry : *budget) {
    if (word(entry, "variable") == variable && entry.contains("parts")) entries.push_back(entry);
  }
  return entries;
}

/// The names of all parts, in the order in which they first occur.
std::vector<std::string> part_names(const std::vector<Json>& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    for (const auto& part : entry.at("parts")) {
      const std::string name = word(part, "name");
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

const Json* find_part(const Json& entry, const std::string& name) {
  for (const auto& part : entry.at("parts")) {
    if (word(part, "name") == name) return &part;
  }
  return nullptr;
}

std::optional<double> number_of_part(const Json& entry, const std::string& name,
                                     std::string_view key) {
  const Json* part = find_part(entry, name);
  return part ? number(*part, key) : std::nullopt;
}

/// Hue and hatching of a part: neither is needed to tell them apart.
struct BarStyle {
  const char* colour;
  const char* pattern;
};

BarStyle bar_style(std::size_t k) {
  constexpr std::array<BarStyle, 7> kStyles{{{"#D55E00", ""},
                                             {"#E69F00", "/"},
                                             {"#0072B2", ""},
                                             {"#009E73", "\\"},
                                             {"#56B4E9", "x"},
                                             {"#999999", "."},
                                             {"#CC79A7", "-"}}};
  return kStyles[k % kStyles.size()];
}

Json total_trace(const std::vector<Json>& entries) {
  Json x = Json::array(), y = Json::array();
  for (const auto& entry : entries) {
    const auto total = number(entry, "total");
    if (!total || *total <= 0) continue;
    x.push_back(*total);
    y.push_back(word(entry, "solution"));
  }
  return {
      {"type", "scatter"},
      {"mode", "markers"},
      {"name", "total"},
      {"legendgroup", "part total"},
      {"x", x},
      {"y", y},
      {"marker",
       {{"symbol", "line-ns-open"}, {"size", 16}, {"color", "#000000"}, {"line", {{"width", 2}}}}},
      {"hovertemplate", "%{y}: total %{x:.3g}"}};
}

Json bars(const std::vector<Json>& entries, const std::string& name, std::size_t k) {
  Json x = Json::array(), y = Json::array(), errors = Json::array(), steps = Json::array();
  for (const auto& entry : entries) {
    const Json* part = find_part(entry, name);
    if (part == nullptr) continue;
    const auto l1 = number(*part, "l1");
    if (!l1 || *l1 <= 0) continue;  // nothing to draw on a logarithmic axis
    x.push_back(*l1);
    y.push_back(word(entry, "solution"));
    errors.push_back(number(*part, "uncertainty").value_or(0));
    steps.push_back(fmt::format("{} \u2192 {}", word(*part, "from"), word(*part, "to")));
  }
  const BarStyle style = bar_style(k);
  return {{"type", "bar"},
          {"orientation", "h"},
          {"name", name},
          {"legendgroup", "part " + name},
          {"x", x},
          {"y", y},
          {"customdata", steps},
          {"error_x", {{"type", "data"}, {"array", errors}, {"thickness", 1}, {"width", 2}}},
          {"marker",
           {{"color", style.colour},
            {"pattern",
             {{"shape", style.pattern},
              {"fillmode", "overlay"},
              {"fgcolor", "#ffffff"},
              {"size", 6}}}}},
          {"hovertemplate", "%{y}: %{x:.3g}<br>%{customdata}"}};
}

Json log_range(const std::vector<Json>& entries, const std::vector<std::string>& names) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  const auto include = [&](const std::optional<double>& value) {
    if (!value || *value <= 0) return;
    least = std::min(least, *value);
    most = std::max(most, *value);
  };
  for (const auto& entry : entries) {
    include(number(entry, "total"));
    for (const auto& name : names) include(number_of_part(entry, name, "l1"));
  }
  if (most == 0) return {-4, 0};
  return {std::log10(least) - 0.5, std::log10(most) + 0.3};
}

Json figure(const std::vector<Json>& entries, const std::string& variable) {
  const auto names = part_names(entries);
  Json data = Json::array();
  for (std::size_t k = 0; k < names.size(); ++k) data.push_back(bars(entries, names[k], k));
  data.push_back(total_trace(entries));
  Json solutions = Json::array();
  for (const auto& entry : entries) solutions.push_back(word(entry, "solution"));
  return {{"height", 140 + 44 * solutions.size()},
          {"arrays", Json::object()},
          {"data", data},
          {"layout",
           {{"barmode", "group"},
            {"bargap", 0.25},
            {"hovermode", "closest"},
            {"xaxis",
             {{"type", "log"},
              {"dtick", 1},
              {"exponentformat", "power"},
              {"range", log_range(entries, names)},
              {"title", {{"text", fmt::format("L1 in p({})", variable_text(variable))}}}}},
            {"yaxis",
             {{"autorange", "reversed"},
              {"type", "category"},
              {"categoryorder", "array"},
              {"categoryarray", solutions}}}}}};
}

std::string with_uncertainty(const Json& entry, const std::string& name) {
  std::string text = number_text(number_of_part(entry, name, "l1"), 2);
  const auto uncertainty = number_of_part(entry, name, "uncertainty");
  if (uncertainty) text += " \u00b1 " + number_text(uncertainty, 1);
  return text;
}

std::string l1_table(const std::vector<Json>& entries, const std::string& variable) {
  const auto names = part_names(entries);
  std::vector<HtmlColumn> columns{{"solution", Align::left}, {"total"}};
  for (const auto& name : names) columns.push_back({name});
  columns.push_back({"sampling: chance expects"});
  columns.push_back({"in 99 runs of 100 below"});
  for (const auto& entry : entries) {
    auto column = columns.begin();
    const auto put = [&](const std::string& text) { (column++)->cells.push_back(text); };
    put(word(entry, "solution"));
    put(number_text(number(entry, "total"), 2));
    for (const auto& name : names) put(with_uncertainty(entry, name));
    put(number_text(number_of_part(entry, "sampling", "expected"), 2));
    put(number_text(number_of_part(entry, "sampling", "in_99"), 2));
  }
  return table_html(fmt::format("Error budget of p({}): L1", variable_text(variable)),
                    std::move(columns));
}

std::string tail_table(const std::vector<Json>& entries, const std::string& variable) {
  const auto names = part_names(entries);
  std::vector<HtmlColumn> columns{{"solution", Align::left}, {"total"}};
  for (const auto& name : names) columns.push_back({name});
  for (const auto& entry : entries) {
    auto column = columns.begin();
    const auto put = [&](const std::string& text) { (column++)->cells.push_back(text); };
    put(word(entry, "solution"));
    put(number_text(number(entry, "total_tail"), 2));
    for (const auto& name : names) put(number_text(number_of_part(entry, name, "tail"), 2));
  }
  return table_html(fmt::format("Error budget of the tail of p({}): mean |\u0394 log10 p|",
                                variable_text(variable)),
                    std::move(columns));
}

}  // namespace

std::vector<Plot> budget_plots(const Json& summary_case, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const std::string variable : {"y", "ydot"}) {
    const auto entries = entries_of(summary_case, variable);
    if (entries.empty()) continue;
    plots.push_back({prefix + "-budget-" + variable,
                     fmt::format("Error budget of p({})", variable_text(variable)),
                     figure(entries, variable)});
  }
  return plots;
}

std::string budget_tables(const Json& summary_case) {
  std::string html;
  for (const std::string variable : {"y", "ydot"}) {
    const auto entries = entries_of(summary_case, variable);
    if (!entries.empty()) html += l1_table(entries, variable) + tail_table(entries, variable);
  }
  return html;
}

}  // namespace fpkcheck::compare
