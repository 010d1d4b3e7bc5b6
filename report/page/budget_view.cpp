#include "report/page/budget_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "compare/budget.hpp"
#include "report/budget/part_look.hpp"
#include "report/page/html.hpp"
#include "report/page/log_range.hpp"
#include "report/page/number_text.hpp"

namespace fpkcheck::report {
namespace {

using Json = nlohmann::ordered_json;
using compare::BudgetPart;
using compare::BudgetRow;
using compare::ClosureBudget;
using transform::Variable;

/// The budget of a closure for a marginal.
struct LabelledRow {
  std::string label;  ///< id of the closure, with kMark if not ok
  const BudgetRow* row;
};

/// The budgets for a marginal, and the names of all parts in the order of the chain.
struct Side {
  Variable variable;
  std::vector<LabelledRow> rows;
  std::vector<std::string> parts;
};

constexpr const char* kMark = " *";

std::vector<Side> sides_of(const results::Case& one) {
  const auto budgets = compare::closure_budgets(one.budget, one.solutions);
  std::vector<Side> sides;
  for (const Variable variable : transform::kVariables) {
    Side side{variable, {}, compare::part_names(budgets)};
    for (const auto& budget : budgets) {
      const bool is_ok = budget.status == transform::Status::ok;
      const BudgetRow* row = budget.row(variable);
      if (row != nullptr) side.rows.push_back({budget.solution + (is_ok ? "" : kMark), row});
    }
    if (!side.rows.empty()) sides.push_back(std::move(side));
  }
  return sides;
}

Json total_trace(const Side& side) {
  Json x = Json::array(), y = Json::array();
  for (const auto& [label, row] : side.rows) {
    if (!(row->total > 0)) continue;
    x.push_back(row->total);
    y.push_back(plotly_text(label));
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

Json bars(const Side& side, const std::string& name) {
  Json x = Json::array(), y = Json::array(), errors = Json::array(), steps = Json::array();
  for (const auto& [label, row] : side.rows) {
    const BudgetPart* part = row->find(name);
    // A logarithmic axis has positive values only.
    if (part == nullptr || !(part->l1 > 0)) continue;
    x.push_back(part->l1);
    y.push_back(plotly_text(label));
    errors.push_back(part->uncertainty.value_or(0));
    steps.push_back(plotly_text(fmt::format("{} \u2192 {}", part->from, part->to)));
  }
  return {{"type", "bar"},
          {"orientation", "h"},
          {"name", plotly_text(name)},
          {"legendgroup", "part " + name},
          {"x", x},
          {"y", y},
          {"customdata", steps},
          {"error_x", {{"type", "data"}, {"array", errors}, {"thickness", 1}, {"width", 2}}},
          {"marker",
           {{"color", part_colour(name)},
            {"pattern",
             {{"shape", part_pattern(name)},
              {"fillmode", "overlay"},
              {"fgcolor", "#ffffff"},
              {"size", 6}}}}},
          {"hovertemplate", "%{y}: %{x:.3g}<br>%{customdata}"}};
}

std::string figure(const Side& side) {
  Json data = Json::array(), labels = Json::array();
  for (const auto& name : side.parts) data.push_back(bars(side, name));
  data.push_back(total_trace(side));
  LogRange range;
  for (const auto& [label, row] : side.rows) {
    labels.push_back(plotly_text(label));
    range.include(row->total);
    for (const auto& part : row->parts) range.include(part.l1);
  }
  const Json json{{"height", 140 + 44 * side.rows.size()},
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
                      {"range", range.exponents(0.5, 0.3)},
                      {"title", {{"text", "L1 in " + density_text(side.variable)}}}}},
                    {"yaxis",
                     {{"autorange", "reversed"},
                      {"type", "category"},
                      {"categoryorder", "array"},
                      {"categoryarray", labels}}}}}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// Makes the cell of a part.
using PartCell = std::function<std::string(const BudgetPart&)>;

// The columns of closures, totals and parts.
std::vector<HtmlColumn> columns_of(const Side& side, const std::function<std::string(double)>& text,
                                   double BudgetRow::*total, const PartCell& cell) {
  std::vector<HtmlColumn> columns{{"solution", Align::left}, {"total"}};
  for (const auto& [label, row] : side.rows) {
    columns[0].cells.push_back(label);
    columns[1].cells.push_back(text(row->*total));
  }
  for (const auto& name : side.parts) {
    HtmlColumn column{name};
    for (const auto& [label, row] : side.rows) {
      const BudgetPart* part = row->find(name);
      column.cells.push_back(part != nullptr ? cell(*part) : std::string(kNoValue));
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

// A column with a sampling error of the last step of the chain.
HtmlColumn chance_column(const Side& side, const std::string& header,
                         std::optional<double> BudgetPart::*member) {
  HtmlColumn column{header};
  for (const auto& [label, row] : side.rows) {
    column.cells.push_back(l1_cell(row->parts.back().*member));
  }
  return column;
}

std::string l1_table(const Side& side) {
  const auto with_uncertainty = [](const BudgetPart& part) {
    const std::string l1 = l1_cell(part.l1);
    return part.uncertainty ? l1 + " \u00b1 " + l1_cell(part.uncertainty) : l1;
  };
  auto columns = columns_of(side, l1_cell, &BudgetRow::total, with_uncertainty);
  columns.push_back(chance_column(side, "L1 of sampling error alone: mean", &BudgetPart::expected));
  columns.push_back(
      chance_column(side, "L1 of sampling error alone: 99 % quantile", &BudgetPart::in_99));
  return table_html(fmt::format("Error budget of {}: L1", density_text(side.variable)),
                    std::move(columns));
}

std::string tail_table(const Side& side) {
  const auto text = [](double tail) {
    return std::isfinite(tail) ? fmt::format("{:.3f}", tail) : std::string(kNoValue);
  };
  const auto cell = [&](const BudgetPart& part) { return text(part.tail); };
  return table_html(fmt::format("Error budget of the tail of {}: mean |\u0394 log10 p|",
                                density_text(side.variable)),
                    columns_of(side, text, &BudgetRow::total_tail, cell));
}

}  // namespace

std::string budget_introduction(const results::Case& one) {
  if (one.budget.empty()) return "";
  return fmt::format(
      "<p>Contribution of each step of the chain from a closure to {}: L1, and in the tail the "
      "mean |\u0394 log<sub>10</sub> p|. The total is at most the sum of the parts, and smaller if "
      "parts cancel. (<a href=\"#budget-terms\">Definition of the parts</a>)</p>\n",
      escaped(one.budget.front().reference));
}

std::vector<Plot> budget_plots(const results::Case& one, const std::string& prefix) {
  std::vector<Plot> plots;
  for (const auto& side : sides_of(one)) {
    const bool marked =
        std::ranges::any_of(side.rows, [](const auto& row) { return row.label.ends_with(kMark); });
    plots.push_back({fmt::format("{}-budget-{}", prefix, name(side.variable)),
                     fmt::format("Error budget of {}{}", density_text(side.variable),
                                 marked ? "; *: not ok" : ""),
                     figure(side)});
  }
  return plots;
}

std::string budget_tables(const results::Case& one) {
  std::string html;
  for (const auto& side : sides_of(one)) html += l1_table(side) + tail_table(side);
  return html;
}

}  // namespace fpkcheck::report
