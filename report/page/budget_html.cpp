#include "report/page/page_sections.hpp"

#include "report/figure/script_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <optional>

#include "compare/error_budget.hpp"
#include "report/page/html_elements.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using transform::StateVariable;

/// The error budget of one closure for one marginal density.
struct ErrorBudgetRowWithClosureId {
  std::string label;  ///< id of the closure, with kNotOkMark if not ok
  const ErrorBudgetRow* row;
};

/// The error budgets of all closures for one marginal density, and the names of all parts in the
/// order in which the approximations are removed.
struct ErrorBudgetsOfMarginal {
  StateVariable variable;
  std::vector<ErrorBudgetRowWithClosureId> rows;
  std::vector<std::string> parts;
};

constexpr const char* kNotOkMark = " *";

std::vector<ErrorBudgetsOfMarginal> marginal_budgets(const results::CaseResult& case_result) {
  const auto budgets = compare::group_budget_by_closure(case_result.budget, case_result.solutions);
  std::vector<ErrorBudgetsOfMarginal> marginals;
  for (const StateVariable variable : transform::kVariables) {
    ErrorBudgetsOfMarginal marginal{variable, {}, compare::budget_part_names(budgets)};
    for (const auto& budget : budgets) {
      const bool has_status_ok = budget.status == transform::Status::ok;
      const ErrorBudgetRow* row = budget.budget_row_of(variable);
      if (row != nullptr)
        marginal.rows.push_back({budget.solution + (has_status_ok ? "" : kNotOkMark), row});
    }
    if (!marginal.rows.empty()) marginals.push_back(std::move(marginal));
  }
  return marginals;
}

using PartCell = std::function<std::string(const ErrorBudgetPart&)>;

// Returns the table columns of closures, total distances and parts of the error budget.
std::vector<HtmlTableColumn> budget_part_columns(const ErrorBudgetsOfMarginal& marginal,
                                                 const std::function<std::string(double)>& text,
                                                 double ErrorBudgetRow::*total,
                                                 const PartCell& cell) {
  std::vector<HtmlTableColumn> columns{{"solution", TextAlignment::left}, {"total"}};
  for (const auto& [label, row] : marginal.rows) {
    columns[0].cells.push_back(label);
    columns[1].cells.push_back(text(row->*total));
  }
  for (const auto& name : marginal.parts) {
    HtmlTableColumn column{name};
    for (const auto& [label, row] : marginal.rows) {
      const ErrorBudgetPart* part = row->find_budget_part(name);
      column.cells.push_back(part != nullptr ? cell(*part) : std::string(kNoValue));
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

// Returns a table column with a sampling error of the last budget part, which is the distance from
// the simulation.
HtmlTableColumn sampling_error_column(const ErrorBudgetsOfMarginal& marginal,
                                      const std::string& header,
                                      std::optional<double> ErrorBudgetPart::*member) {
  HtmlTableColumn column{header};
  for (const auto& [label, row] : marginal.rows) {
    column.cells.push_back(l1_distance_cell_text(row->parts.back().*member));
  }
  return column;
}

std::string l1_budget_table_html(const ErrorBudgetsOfMarginal& marginal) {
  const auto with_uncertainty = [](const ErrorBudgetPart& part) {
    const std::string l1 = l1_distance_cell_text(part.l1);
    return part.uncertainty ? l1 + " \u00b1 " + l1_distance_cell_text(part.uncertainty) : l1;
  };
  auto columns = budget_part_columns(marginal, l1_distance_cell_text, &ErrorBudgetRow::total,
                                     with_uncertainty);
  columns.push_back(sampling_error_column(marginal, "L1 of sampling error alone: mean",
                                          &ErrorBudgetPart::expected));
  columns.push_back(sampling_error_column(marginal, "L1 of sampling error alone: 99 % quantile",
                                          &ErrorBudgetPart::quantile_99));
  return table_html(fmt::format("Error budget of {}: L1", density_in_plain_text(marginal.variable)),
                    std::move(columns));
}

std::string tail_budget_table_html(const ErrorBudgetsOfMarginal& marginal) {
  const auto text = [](double tail) {
    return std::isfinite(tail) ? fmt::format("{:.3f}", tail) : std::string(kNoValue);
  };
  const auto cell = [&](const ErrorBudgetPart& part) { return text(part.tail); };
  return table_html(fmt::format("Error budget of the tail of {}: mean |\u0394 log10 p|",
                                density_in_plain_text(marginal.variable)),
                    budget_part_columns(marginal, text, &ErrorBudgetRow::total_tail, cell));
}

}  // namespace

std::string error_budget_introduction_html(const results::CaseResult& case_result) {
  if (case_result.budget.empty()) return "";
  return fmt::format(
      "<p>Contribution of each step of the chain from a closure to {}: L1, and in the tail the "
      "mean |\u0394 log<sub>10</sub> p|. The total is at most the sum of the parts, and smaller if "
      "parts cancel. (<a href=\"#budget-terms\">Definition of the parts</a>)</p>\n",
      escape_html(case_result.budget.front().reference));
}

std::string error_budget_tables_html(const results::CaseResult& case_result) {
  std::string html;
  for (const auto& marginal : marginal_budgets(case_result))
    html += l1_budget_table_html(marginal) + tail_budget_table_html(marginal);
  return html;
}

}  // namespace fpkcheck::report
