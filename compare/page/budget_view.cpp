#include "compare/page/budget_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "compare/budget/view.hpp"
#include "compare/page/html.hpp"
#include "compare/page/number_text.hpp"
#include "compare/summary_view.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

/// A closure's row of "budget" in one variable.
struct BudgetRow {
  std::string label;  ///< the closure's id, marked where it is not ok
  const Json* json;
};
using BudgetRows = std::vector<BudgetRow>;

constexpr const char* kMark = " *";

BudgetRows rows_of(const std::vector<ClosureBudget>& budgets, const std::string& variable) {
  BudgetRows rows;
  for (const auto& budget : budgets) {
    const Json* row = variable == "y" ? budget.y : budget.ydot;
    if (row != nullptr)
      rows.push_back({budget.solution + (budget.status == "ok" ? "" : kMark), row});
  }
  return rows;
}

bool any_marked(const BudgetRows& rows) {
  return std::ranges::any_of(rows, [](const auto& row) { return row.label.ends_with(kMark); });
}

std::optional<double> number_of_part(const BudgetRow& row, const std::string& name,
                                     std::string_view key) {
  const Json* part = find_part(row.json, name);
  return part ? number(*part, key) : std::nullopt;
}

// Hatching of a part: its colour alone need not tell it from the others.
const char* pattern(const std::string& part) {
  if (part == "impact") return "/";
  if (part == "white noise") return "|";
  if (part == "discretisation") return "\\";
  if (part == "sampling") return "x";
  return part == "closure" || part == "truncation" ? "" : ".";
}

Json total_trace(const BudgetRows& rows) {
  Json x = Json::array(), y = Json::array();
  for (const auto& row : rows) {
    const auto total = number(*row.json, "total");
    if (!total || *total <= 0) continue;
    x.push_back(*total);
    y.push_back(row.label);
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

Json bars(const BudgetRows& rows, const std::string& name) {
  Json x = Json::array(), y = Json::array(), errors = Json::array(), steps = Json::array();
  for (const auto& row : rows) {
    const Json* part = find_part(row.json, name);
    if (part == nullptr) continue;
    const auto l1 = number(*part, "l1");
    if (!l1 || *l1 <= 0) continue;  // nothing to draw on a logarithmic axis
    x.push_back(*l1);
    y.push_back(row.label);
    errors.push_back(number(*part, "uncertainty").value_or(0));
    steps.push_back(fmt::format("{} \u2192 {}", word(*part, "from"), word(*part, "to")));
  }
  return {{"type", "bar"},
          {"orientation", "h"},
          {"name", name},
          {"legendgroup", "part " + name},
          {"x", x},
          {"y", y},
          {"customdata", steps},
          {"error_x", {{"type", "data"}, {"array", errors}, {"thickness", 1}, {"width", 2}}},
          {"marker",
           {{"color", part_colour(name)},
            {"pattern",
             {{"shape", pattern(name)},
              {"fillmode", "overlay"},
              {"fgcolor", "#ffffff"},
              {"size", 6}}}}},
          {"hovertemplate", "%{y}: %{x:.3g}<br>%{customdata}"}};
}

Json log_range(const BudgetRows& rows, const std::vector<std::string>& names) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  const auto include = [&](const std::optional<double>& value) {
    if (!value || *value <= 0) return;
    least = std::min(least, *value);
    most = std::max(most, *value);
  };
  for (const auto& row : rows) {
    include(number(*row.json, "total"));
    for (const auto& name : names) include(number_of_part(row, name, "l1"));
  }
  if (most == 0) return {-4, 0};
  return {std::log10(least) - 0.5, std::log10(most) + 0.3};
}

Json figure(const BudgetRows& rows, const std::vector<std::string>& names,
            const std::string& variable) {
  Json data = Json::array();
  for (const auto& name : names) data.push_back(bars(rows, name));
  data.push_back(total_trace(rows));
  Json solutions = Json::array();
  for (const auto& row : rows) solutions.push_back(row.label);
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
              {"range", log_range(rows, names)},
              {"title", {{"text", fmt::format("L1 in p({})", variable_text(variable))}}}}},
            {"yaxis",
             {{"autorange", "reversed"},
              {"type", "category"},
              {"categoryorder", "array"},
              {"categoryarray", solutions}}}}}};
}

std::string with_uncertainty(const BudgetRow& row, const std::string& name) {
  std::string text = l1_cell(number_of_part(row, name, "l1"));
  const auto uncertainty = number_of_part(row, name, "uncertainty");
  if (uncertainty) text += " \u00b1 " + l1_cell(uncertainty);
  return text;
}

std::string l1_table(const BudgetRows& rows, const std::vector<std::string>& names,
                     const std::string& variable) {
  std::vector<HtmlColumn> columns{{"solution", Align::left}, {"total"}};
  for (const auto& name : names) columns.push_back({name});
  columns.push_back({"L1 that chance alone makes: mean"});
  columns.push_back({"exceeded in 1 run of 100"});
  for (const auto& row : rows) {
    auto column = columns.begin();
    const auto put = [&](const std::string& text) { (column++)->cells.push_back(text); };
    put(row.label);
    put(l1_cell(number(*row.json, "total")));
    for (const auto& name : names) put(with_uncertainty(row, name));
    put(l1_cell(number_of_part(row, "sampling", "expected")));
    put(l1_cell(number_of_part(row, "sampling", "in_99")));
  }
  return table_html(fmt::format("Error budget of p({}): L1", variable_text(variable)),
                    std::move(columns));
}

std::string tail_cell(const std::optional<double>& tail) {
  return tail ? fmt::format("{:.3f}", *tail) : std::string(kNoValue);
}

std::string tail_table(const BudgetRows& rows, const std::vector<std::string>& names,
                       const std::string& variable) {
  std::vector<HtmlColumn> columns{{"solution", Align::left}, {"total"}};
  for (const auto& name : names) columns.push_back({name});
  for (const auto& row : rows) {
    auto column = columns.begin();
    const auto put = [&](const std::string& text) { (column++)->cells.push_back(text); };
    put(row.label);
    put(tail_cell(number(*row.json, "total_tail")));
    for (const auto& name : names) put(tail_cell(number_of_part(row, name, "tail")));
  }
  return table_html(fmt::format("Error budget of the tail of p({}): mean |\u0394 log10 p|",
                                variable_text(variable)),
                    std::move(columns));
}

}  // namespace

std::vector<Plot> budget_plots(const Json& summary_case, const std::string& prefix) {
  const auto budgets = closure_budgets(summary_case);
  std::vector<Plot> plots;
  for (const std::string variable : {"y", "ydot"}) {
    const auto rows = rows_of(budgets, variable);
    if (rows.empty()) continue;
    plots.push_back({prefix + "-budget-" + variable,
                     fmt::format("Error budget of p({}){}", variable_text(variable),
                                 any_marked(rows) ? "; *: not admissible" : ""),
                     figure(rows, part_names(budgets), variable)});
  }
  return plots;
}

std::string budget_tables(const Json& summary_case) {
  const auto budgets = closure_budgets(summary_case);
  const auto names = part_names(budgets);
  std::string html;
  for (const std::string variable : {"y", "ydot"}) {
    const auto rows = rows_of(budgets, variable);
    if (!rows.empty()) html += l1_table(rows, names, variable) + tail_table(rows, names, variable);
  }
  return html;
}

}  // namespace fpkcheck::compare
