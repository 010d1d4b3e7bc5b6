#include "report/terminal_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "compare/error_budget.hpp"
#include "problem/equation_and_impact_condition.hpp"

namespace fpkcheck::report {
namespace {

using compare::ModelApproximation;

constexpr const char* kSolvesColumn = "solves";

bool has_group_with_prefix(const std::vector<TextTableColumn>& columns, std::string_view start) {
  return std::ranges::any_of(columns,
                             [&](const TextTableColumn& c) { return c.group.starts_with(start); });
}

bool has_header_containing(const std::vector<TextTableColumn>& columns, std::string_view part) {
  return std::ranges::any_of(
      columns, [&](const TextTableColumn& c) { return c.header.find(part) != std::string::npos; });
}

template <class Condition>
bool has_cell_satisfying(const std::vector<TextTableColumn>& columns, std::string_view header,
                         Condition condition) {
  return std::ranges::any_of(columns, [&](const TextTableColumn& c) {
    return c.header == header && std::ranges::any_of(c.cells, condition);
  });
}

template <class Enum>
std::string enum_legend(const std::vector<TextTableColumn>& results, const std::string& before,
                        const std::string& after) {
  std::vector<std::string> terms;
  for (const auto& [value, name, meaning] : enumerator_names(Enum{})) {
    const std::string part = fmt::format("{}{}{}", before, name, after);
    if (has_cell_satisfying(results, kSolvesColumn, [&](const auto& cell) {
          return after.empty() ? cell.ends_with(part) : cell.starts_with(part);
        })) {
      terms.push_back(fmt::format("{}: {}", name, meaning));
    }
  }
  return fmt::format("{}", fmt::join(terms, "; "));
}

std::string solves_legend(const std::vector<TextTableColumn>& results) {
  const auto equations = enum_legend<problem::DensityEquation>(results, "", "/");
  const auto impacts = enum_legend<problem::ImpactCondition>(results, "/", "");
  std::vector<std::string> terms;
  if (!equations.empty()) terms.push_back(fmt::format("the excitation term ({})", equations));
  if (!impacts.empty()) terms.push_back(fmt::format("the impact ({})", impacts));
  if (has_cell_satisfying(results, kSolvesColumn,
                          [](const auto& cell) { return cell.starts_with("given/"); })) {
    terms.emplace_back("given: an external density");
  }
  return fmt::format("{}: {}.", kSolvesColumn, fmt::join(terms, " / "));
}

}  // namespace

std::string solutions_table_legend(const std::vector<TextTableColumn>& results,
                                   const results::Run& run) {
  std::vector<std::string> sentences;
  const bool distances = has_group_with_prefix(results, "L1");
  if (distances) {
    sentences.emplace_back(
        "L1: integral of |p - reference|, 0 for equal densities, 2 for disjoint ones.");
    const bool smooth = std::ranges::any_of(run.cases, [](const results::CaseResult& case_result) {
      return !case_result.smooth.empty();
    });
    if (smooth) {
      sentences.emplace_back(
          "Distances to a simulation with control variates are over smooth bins, which do not "
          "resolve narrower features.");
    }
  }
  if (has_header_containing(results, kSolvesColumn)) sentences.push_back(solves_legend(results));
  if (has_header_containing(results, "energy")) {
    sentences.emplace_back("energy: residual of the power balance relative to the input.");
  }
  if (has_header_containing(results, "sec")) sentences.emplace_back("sec: wall-clock time.");
  if (distances || has_header_containing(results, "E[")) {
    sentences.emplace_back(has_header_containing(results, "sec")
                               ? "All other quantities are non-dimensional."
                               : "All quantities are non-dimensional.");
  }
  return fmt::format("{}", fmt::join(sentences, " "));
}

std::string error_budget_table_legend(const std::vector<TextTableColumn>& budgets) {
  if (budgets.empty()) return "";
  const auto has_row = [&](std::string_view name) {
    return has_cell_satisfying(budgets, "error budget",
                               [&](const auto& cell) { return cell == name; });
  };
  std::vector<std::string> rows_below;
  for (const auto& approximations :
       {std::vector{ModelApproximation::discretisation}, std::vector{ModelApproximation::sampling},
        std::vector{ModelApproximation::discretisation, ModelApproximation::sampling}}) {
    if (has_row(compare::name(approximations))) rows_below.push_back(compare::name(approximations));
  }
  std::string text =
      "error budget: total is the L1 distance from each closure to the end of its chain of models "
      "(the simulation, if any); total is at most the sum of its parts";
  if (!rows_below.empty()) {
    text += fmt::format(" and of the row{} {}", rows_below.size() > 1 ? "s" : "",
                        fmt::join(rows_below, " and "));
  }
  for (const auto& [approximation, name, meaning] : compare::kApproximationNames) {
    const std::string header = error_budget_part_header(std::string(name));
    // If the solution between two approximations is missing, the approximations share a table
    // column "closure + impact".
    if (!has_header_containing(budgets, header) && !has_header_containing(budgets, name)) continue;
    text += fmt::format("; {}: {}", header, meaning);
    if (approximation == ModelApproximation::closure)
      text += ", against its own equation discretised";
  }
  if (has_group_with_prefix(budgets, "tail")) {
    text += "; tail: mean |log10 p - log10 q|, with q the end of the chain";
  }
  if (has_cell_satisfying(budgets, "error budget",
                          [](const auto& cell) { return cell.ends_with('*'); })) {
    text += "; *: the closure is not ok";
  }
  return text + '.';
}

}  // namespace fpkcheck::report
