#include "report/terminal_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/text/number_text.hpp"
#include "report/text/text_layout.hpp"
#include "results/run.hpp"

namespace fpkcheck::report {
namespace {

using compare::ClosureErrorBudget;
using compare::ErrorBudgetPart;
using compare::ErrorBudgetRow;
using compare::ModelApproximation;
using transform::StateVariable;

constexpr int kTailImportance = 1, kLastPartImportance = 2;

std::string l1_or_missing_cell(double l1) {
  return std::isfinite(l1) ? l1_distance_text(l1) : kMissingCell;
}

std::string tail_distance_cell(double tail) {
  return std::isfinite(tail) ? fmt::format("{:.3f}", tail) : kMissingCell;
}

const ErrorBudgetPart* find_part(const ErrorBudgetRow* row, const std::string& name) {
  return row == nullptr ? nullptr : row->find_budget_part(name);
}

bool is_common_to_closures(const std::vector<ClosureErrorBudget>& budgets,
                           const std::string& name) {
  return std::ranges::any_of(budgets, [&](const ClosureErrorBudget& budget) {
    const ErrorBudgetPart* part = find_part(budget.existing_budget_rows().front(), name);
    return part != nullptr && part->is_reference_error();
  });
}

/// Builds the columns of the error budget table for one marginal density. A table column has a cell
/// for each closure, then a cell for each part of the error budget whose value all closures share.
class ErrorBudgetTableColumns {
 public:
  ErrorBudgetTableColumns(const std::vector<ClosureErrorBudget>& budgets,
                          const std::vector<std::string>& below, StateVariable variable)
      : budgets_(budgets), below_(below), variable_(variable) {}

  std::string symbol() const { return variable_ == StateVariable::y ? "p(y)" : "p(y')"; }

  TextTableColumn total() const {
    return with_rows_below({"L1 of " + symbol(), "total", false, kAlwaysShown}, l1_or_missing_cell,
                           &ErrorBudgetRow::total, &ErrorBudgetPart::l1);
  }

  TextTableColumn tail() const {
    return with_rows_below({"tail", symbol(), false, kTailImportance}, tail_distance_cell,
                           &ErrorBudgetRow::total_tail, &ErrorBudgetPart::tail);
  }

  TextTableColumn part(const std::string& name, int importance) const {
    TextTableColumn column{"L1 of " + symbol(), error_budget_part_header(name), false, importance};
    for (const auto& budget : budgets_) {
      const ErrorBudgetPart* part = find_part(budget.budget_row_of(variable_), name);
      column.cells.push_back(part ? l1_or_missing_cell(part->l1) : kMissingCell);
    }
    column.cells.resize(column.cells.size() + below_.size(), kMissingCell);
    return column;
  }

 private:
  TextTableColumn with_rows_below(TextTableColumn column, std::string (*cell)(double),
                                  double ErrorBudgetRow::*of_row,
                                  double ErrorBudgetPart::*of_part) const {
    for (const auto& budget : budgets_) {
      const ErrorBudgetRow* row = budget.budget_row_of(variable_);
      column.cells.push_back(row ? cell(row->*of_row) : kMissingCell);
    }
    for (const auto& name : below_) {
      const ErrorBudgetPart* part = nullptr;
      for (auto budget = budgets_.begin(); part == nullptr && budget != budgets_.end(); ++budget) {
        part = find_part(budget->budget_row_of(variable_), name);
      }
      column.cells.push_back(part ? cell(part->*of_part) : kMissingCell);
    }
    return column;
  }

  const std::vector<ClosureErrorBudget>& budgets_;
  const std::vector<std::string>& below_;
  StateVariable variable_;
};

TextTableColumn closure_and_part_names(const std::vector<ClosureErrorBudget>& budgets,
                                       const std::vector<std::string>& below) {
  TextTableColumn column{"", "error budget", true, kAlwaysShown};
  for (const auto& budget : budgets) {
    column.cells.push_back(budget.solution + (budget.status == transform::Status::ok ? "" : "*"));
  }
  column.cells.insert(column.cells.end(), below.begin(), below.end());
  return column;
}

}  // namespace

std::string error_budget_part_header(const std::string& part) {
  if (part == name(ModelApproximation::truncation)) return "trunc.";
  if (part == name(ModelApproximation::white_noise)) return "white";
  return part;
}

std::vector<TextTableColumn> displayed_budget_columns(const results::CaseResult& case_result,
                                                      const TerminalTextFormat& format) {
  const auto budgets = compare::group_budget_by_closure(case_result.budget, case_result.solutions);
  if (budgets.empty()) return {};
  std::vector<std::string> beside, below;
  for (const auto& name : compare::budget_part_names(budgets)) {
    (is_common_to_closures(budgets, name) ? below : beside).push_back(name);
  }
  std::vector<TextTableColumn> all{closure_and_part_names(budgets, below)}, tails;
  for (const auto variable : transform::kVariables) {
    const ErrorBudgetTableColumns columns(budgets, below, variable);
    all.push_back(columns.total());
    int importance = kLastPartImportance + static_cast<int>(beside.size());
    for (const auto& name : beside) all.push_back(columns.part(name, importance--));
    tails.push_back(columns.tail());
  }
  all.insert(all.end(), tails.begin(), tails.end());
  return select_columns_to_fit(std::move(all), format);
}

std::string error_budget_table_text(const results::CaseResult& case_result,
                                    const TerminalTextFormat& format) {
  const auto columns = displayed_budget_columns(case_result, format);
  if (columns.empty()) return "";
  const std::string text = format_text_table(columns, format);
  const std::string limits = results::limiting_errors_text(case_result);
  return limits.empty() ? text : text + wrap_text("  " + limits, format.width, 2);
}

}  // namespace fpkcheck::report
