#include "compare/budget/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "compare/budget/view.hpp"
#include "compare/summary_view.hpp"
#include "compare/text/columns.hpp"
#include "compare/text/l1_text.hpp"
#include "compare/text/wrapped.hpp"

namespace fpkcheck::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kTailImportance = 1, kLastPartImportance = 2;

std::string l1_or_absent(const std::optional<double>& l1) { return l1 ? l1_text(*l1) : kAbsent; }

std::string tail_or_absent(const std::optional<double>& tail) {
  return tail ? fmt::format("{:.3f}", *tail) : kAbsent;
}

std::string header_of(const std::string& part) {
  if (part == "truncation") return "trunc.";
  if (part == "white noise") return "white";
  return part;
}

bool shown_as_row(const std::vector<ClosureBudget>& budgets, const std::string& name) {
  return std::ranges::any_of(budgets, [&](const ClosureBudget& budget) {
    const Json* part = find_part(rows_of(budget).front(), name);
    return part != nullptr && lies_between_references(*part);
  });
}

/// One variable's columns: the total and the parts that differ from closure to closure.
class VariableColumns {
 public:
  VariableColumns(const std::vector<ClosureBudget>& budgets, const Json* ClosureBudget::*variable,
                  const std::string& symbol)
      : budgets_(budgets), variable_(variable), group_(fmt::format("L1 of {}", symbol)) {}

  Column total(const std::vector<std::string>& rows_below) const {
    Column column{group_, "total", false, kAlwaysShown};
    for (const auto& budget : budgets_) {
      const Json* row = budget.*variable_;
      column.cells.push_back(row ? l1_or_absent(number(*row, "total")) : kAbsent);
    }
    for (const auto& name : rows_below) column.cells.push_back(l1_or_absent(below(name, "l1")));
    return column;
  }

  Column part(const std::string& name, int importance, std::size_t rows_below) const {
    Column column{group_, header_of(name), false, importance};
    for (const auto& budget : budgets_) {
      const Json* part = find_part(budget.*variable_, name);
      column.cells.push_back(part ? l1_or_absent(number(*part, "l1")) : kAbsent);
    }
    column.cells.resize(column.cells.size() + rows_below, kAbsent);
    return column;
  }

  Column tail(const char* symbol, const std::vector<std::string>& rows_below) const {
    Column column{"tail", symbol, false, kTailImportance};
    for (const auto& budget : budgets_) {
      const Json* row = budget.*variable_;
      column.cells.push_back(row ? tail_or_absent(number(*row, "total_tail")) : kAbsent);
    }
    for (const auto& name : rows_below) column.cells.push_back(tail_or_absent(below(name, "tail")));
    return column;
  }

 private:
  // The same for every closure that has it, but for the bins of the tail.
  std::optional<double> below(const std::string& name, const char* key) const {
    for (const auto& budget : budgets_) {
      if (const Json* part = find_part(budget.*variable_, name)) return number(*part, key);
    }
    return std::nullopt;
  }

  const std::vector<ClosureBudget>& budgets_;
  const Json* ClosureBudget::*variable_;
  std::string group_;
};

Column names_column(const std::vector<ClosureBudget>& budgets,
                    const std::vector<std::string>& rows_below) {
  Column column{"", "error budget", true, kAlwaysShown};
  for (const auto& budget : budgets) {
    column.cells.push_back(budget.solution + (budget.status == "ok" ? "" : "*"));
  }
  column.cells.insert(column.cells.end(), rows_below.begin(), rows_below.end());
  return column;
}

}  // namespace

std::vector<Column> budget_columns(const Json& summary_case, const TextFormat& format) {
  const auto budgets = closure_budgets(summary_case);
  if (budgets.empty()) return {};
  std::vector<std::string> beside, below;
  for (const auto& name : part_names(budgets)) {
    (shown_as_row(budgets, name) ? below : beside).push_back(name);
  }
  const VariableColumns y(budgets, &ClosureBudget::y, "p(y)"),
      ydot(budgets, &ClosureBudget::ydot, "p(y')");
  std::vector<Column> all{names_column(budgets, below)};
  for (const auto& variable : {y, ydot}) {
    all.push_back(variable.total(below));
    int importance = kLastPartImportance + static_cast<int>(beside.size());
    for (const auto& name : beside) {
      all.push_back(variable.part(name, importance--, below.size()));
    }
  }
  all.push_back(y.tail("p(y)", below));
  all.push_back(ydot.tail("p(y')", below));
  return fitting(std::move(all), format);
}

std::string budget_table(const Json& summary_case, const TextFormat& format) {
  const auto columns = budget_columns(summary_case, format);
  if (columns.empty()) return "";
  std::string text = rows(columns, format);
  if (const auto sentence = summary_case.find("limits"); sentence != summary_case.end()) {
    text += wrapped("  " + sentence->get<std::string>(), format.width, 2);
  }
  return text;
}

}  // namespace fpkcheck::compare
