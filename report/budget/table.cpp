#include "report/budget/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/text/l1_text.hpp"
#include "report/text/wrap_text.hpp"

namespace fpkcheck::report {
namespace {

using compare::BudgetPart;
using compare::BudgetRow;
using compare::ClosureBudget;
using compare::Link;
using transform::Variable;

constexpr int kTailImportance = 1, kLastPartImportance = 2;

std::string l1_cell(double l1) { return std::isfinite(l1) ? l1_text(l1) : kAbsent; }

std::string tail_cell(double tail) {
  return std::isfinite(tail) ? fmt::format("{:.3f}", tail) : kAbsent;
}

const BudgetPart* find_part(const BudgetRow* row, const std::string& name) {
  return row == nullptr ? nullptr : row->find(name);
}

bool is_common_part(const std::vector<ClosureBudget>& budgets, const std::string& name) {
  return std::ranges::any_of(budgets, [&](const ClosureBudget& budget) {
    const BudgetPart* part = find_part(budget.rows().front(), name);
    return part != nullptr && part->is_reference_error();
  });
}

/// Builds the table columns of one marginal density. A column has a cell for each closure, then a
/// cell for each part that has a row of its own because all closures share its value.
class VariableColumns {
 public:
  VariableColumns(const std::vector<ClosureBudget>& budgets, const std::vector<std::string>& below,
                  Variable variable)
      : budgets_(budgets), below_(below), variable_(variable) {}

  std::string symbol() const { return variable_ == Variable::y ? "p(y)" : "p(y')"; }

  Column total() const {
    return with_rows_below({"L1 of " + symbol(), "total", false, kAlwaysShown}, l1_cell,
                           &BudgetRow::total, &BudgetPart::l1);
  }

  Column tail() const {
    return with_rows_below({"tail", symbol(), false, kTailImportance}, tail_cell,
                           &BudgetRow::total_tail, &BudgetPart::tail);
  }

  Column part(const std::string& name, int importance) const {
    Column column{"L1 of " + symbol(), part_header(name), false, importance};
    for (const auto& budget : budgets_) {
      const BudgetPart* part = find_part(budget.row(variable_), name);
      column.cells.push_back(part ? l1_cell(part->l1) : kAbsent);
    }
    column.cells.resize(column.cells.size() + below_.size(), kAbsent);
    return column;
  }

 private:
  Column with_rows_below(Column column, std::string (*cell)(double), double BudgetRow::*of_row,
                         double BudgetPart::*of_part) const {
    for (const auto& budget : budgets_) {
      const BudgetRow* row = budget.row(variable_);
      column.cells.push_back(row ? cell(row->*of_row) : kAbsent);
    }
    for (const auto& name : below_) {
      const BudgetPart* part = nullptr;
      for (auto budget = budgets_.begin(); part == nullptr && budget != budgets_.end(); ++budget) {
        part = find_part(budget->row(variable_), name);
      }
      column.cells.push_back(part ? cell(part->*of_part) : kAbsent);
    }
    return column;
  }

  const std::vector<ClosureBudget>& budgets_;
  const std::vector<std::string>& below_;
  Variable variable_;
};

Column names_column(const std::vector<ClosureBudget>& budgets,
                    const std::vector<std::string>& below) {
  Column column{"", "error budget", true, kAlwaysShown};
  for (const auto& budget : budgets) {
    column.cells.push_back(budget.solution + (budget.status == transform::Status::ok ? "" : "*"));
  }
  column.cells.insert(column.cells.end(), below.begin(), below.end());
  return column;
}

}  // namespace

std::string part_header(const std::string& part) {
  if (part == name(Link::truncation)) return "trunc.";
  if (part == name(Link::white_noise)) return "white";
  return part;
}

std::vector<Column> budget_columns(const results::Case& case_result, const TextFormat& format) {
  const auto budgets = compare::closure_budgets(case_result.budget, case_result.solutions);
  if (budgets.empty()) return {};
  std::vector<std::string> beside, below;
  for (const auto& name : compare::part_names(budgets)) {
    (is_common_part(budgets, name) ? below : beside).push_back(name);
  }
  std::vector<Column> all{names_column(budgets, below)}, tails;
  for (const auto variable : transform::kVariables) {
    const VariableColumns columns(budgets, below, variable);
    all.push_back(columns.total());
    int importance = kLastPartImportance + static_cast<int>(beside.size());
    for (const auto& name : beside) all.push_back(columns.part(name, importance--));
    tails.push_back(columns.tail());
  }
  all.insert(all.end(), tails.begin(), tails.end());
  return fit_columns(std::move(all), format);
}

std::string budget_table(const results::Case& case_result, const TextFormat& format) {
  const auto columns = budget_columns(case_result, format);
  if (columns.empty()) return "";
  const std::string text = rows(columns, format);
  return case_result.limits.empty() ? text
                                    : text + wrap_text("  " + case_result.limits, format.width, 2);
}

}  // namespace fpkcheck::report
