#include "report/terminal_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "report/case_solutions.hpp"
#include "report/findings.hpp"
#include "report/text/number_text.hpp"
#include "report/text/text_layout.hpp"
#include "report/verdict/verdict.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

std::string moment_text(double x) { return fmt::format("{:#.4g}", x); }

std::string energy_residual_text(double x) { return x == 0 ? "0" : fmt::format("{:.0e}", x); }

std::string seconds_cell_text(double x) {
  return fmt::format("{:.{}f}", x, x < 10 ? 2 : x < 100 ? 1 : 0);
}

std::vector<TextTableColumn> solution_columns(const results::CaseResult& case_result) {
  constexpr int kEnergy = 1, kOtherReference = 2, kSeconds = 3, kSolves = 4, kMoments = 5;
  std::vector<TextTableColumn> all;
  // Adds a table column unless it has no values, such as the distances from the only solution of a
  // case.
  const auto add = [&](TextTableColumn column, const auto& cell) {
    for (const auto& solution : case_result.solutions) {
      // A line with the reason replaces the table row of a solution that is not applicable.
      if (solution.status == transform::Status::not_offered) continue;
      column.cells.push_back(cell(solution));
    }
    const bool empty =
        std::ranges::all_of(column.cells, [](auto& text) { return text == kMissingCell; });
    if (!empty) all.push_back(std::move(column));
  };
  const auto number = [&](const std::string& header, int importance, std::string (*text)(double),
                          const auto& value) {
    add({"", header, false, importance}, [&](const Solution& s) -> std::string {
      const double x = value(s);
      return std::isfinite(x) ? text(x) : kMissingCell;
    });
  };
  const auto of_density = [](const Solution& s, double value) {
    return s.has_density() ? value : std::numeric_limits<double>::quiet_NaN();
  };
  add({"", "solution", true, kAlwaysShown}, [](const Solution& s) { return s.id(); });
  add({"", "solves", true, kSolves},
      [](const Solution& s) { return transform::equation_and_impact_text(s.identity); });
  add(make_status_column(), [](const Solution& s) { return std::string(name(s.status)); });
  number("E[y^2]", kMoments, moment_text,
         [&](const Solution& s) { return of_density(s, s.moments.y2); });
  number("E[y'^2]", kMoments, moment_text,
         [&](const Solution& s) { return of_density(s, s.moments.v2); });
  for (const double wall : walls_with_rest_atoms(case_result)) {
    number(rest_probability_header(case_result, wall), kAlwaysShown, moment_text,
           [&](const Solution& s) { return rest_atom_probability(s, wall); });
  }
  int importance = kAlwaysShown;
  for (const Solution* reference : solutions_of_full_problem(case_result)) {
    for (const auto variable : transform::kVariables) {
      const char* header = variable == transform::StateVariable::y ? "p(y)" : "p(y')";
      add({"L1 to " + reference->id(), header, false, importance},
          [&](const Solution& s) -> std::string {
            const auto l1_distance = case_result.l1_distance(s.id(), reference->id(), variable);
            return l1_distance ? l1_distance_text(*l1_distance) : kMissingCell;
          });
    }
    importance = kOtherReference;
  }
  number("energy", kEnergy, energy_residual_text,
         [&](const Solution& s) { return of_density(s, s.energy_residual); });
  number("sec", kSeconds, seconds_cell_text, [](const Solution& s) { return s.seconds; });
  return all;
}

std::string reasons_text(const results::CaseResult& case_result, std::size_t width) {
  std::string text;
  for (const auto& [solutions, status, reason] : group_status_reasons(case_result)) {
    text += wrap_text(fmt::format("  {} {}: {}", fmt::join(solutions, ", "), name(status), reason),
                      width, 4);
  }
  return text;
}

}  // namespace

std::string case_title(const problem::Problem& problem) {
  return fmt::format("{}: {}", problem.name, problem::non_default_parameters_text(problem));
}

std::string terminal_tables_text(const results::Run& run, const TerminalTextFormat& format) {
  const std::size_t width = format.width;
  const RunVerdict run_verdict = make_run_verdict(run);
  std::string text = verdict_answer_text(run_verdict, format);
  if (!text.empty()) text += '\n';
  std::vector<TextTableColumn> all, budgets;
  std::string missing;
  for (const auto& case_result : run.cases) {
    const auto all_columns = solution_columns(case_result);
    const auto shown = select_columns_to_fit(all_columns, format);
    if (missing.empty()) missing = omitted_column_names(all_columns, shown);
    text += wrap_text(case_title(case_result.problem), width, 2) +
            format_text_table(shown, format) + reasons_text(case_result, width) +
            error_budget_table_text(case_result, format);
    for (const auto& sentence : case_finding_sentences(case_result))
      text += wrap_text("  " + sentence, width, 2);
    text += '\n';
    std::ranges::copy(shown, std::back_inserter(all));
    std::ranges::move(displayed_budget_columns(case_result, format), std::back_inserter(budgets));
  }
  if (!run.stopped.empty()) text += wrap_text(run.stopped, width) + '\n';
  if (!missing.empty()) {
    text += wrap_text(fmt::format("Omitted at {} characters per line: {}. A wider terminal, "
                                  "report.html and summary.json show these columns.",
                                  width, missing),
                      width);
  }
  for (const auto& legend :
       {solutions_table_legend(all, run), error_budget_table_legend(budgets)}) {
    if (!legend.empty()) text += wrap_text(legend, width);
  }
  if (const auto last = run_verdict_text(run, run_verdict, format); !last.empty())
    text += '\n' + last;
  return text;
}

}  // namespace fpkcheck::report
