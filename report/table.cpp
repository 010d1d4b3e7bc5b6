#include "report/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "report/budget/table.hpp"
#include "report/findings.hpp"
#include "report/legend.hpp"
#include "report/reasons.hpp"
#include "report/references.hpp"
#include "report/rest.hpp"
#include "report/text/columns.hpp"
#include "report/text/l1_text.hpp"
#include "report/text/wrapped.hpp"
#include "report/verdict/matrix_text.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;

std::string moment_text(double x) { return fmt::format("{:#.4g}", x); }

std::string energy_text(double x) { return x == 0 ? "0" : fmt::format("{:.0e}", x); }

std::string seconds_text(double x) {
  return fmt::format("{:.{}f}", x, x < 10 ? 2 : x < 100 ? 1 : 0);
}

std::vector<Column> columns(const results::Case& one) {
  constexpr int kEnergy = 1, kOtherReference = 2, kSeconds = 3, kSolves = 4, kMoments = 5;
  std::vector<Column> all;
  // Adds a column unless it has no value, such as the distances to the only solution.
  const auto add = [&](Column column, const auto& cell) {
    for (const auto& solution : one.solutions) {
      // The line of its reason replaces the row.
      if (solution.status == transform::Status::not_offered) continue;
      column.cells.push_back(cell(solution));
    }
    const bool empty =
        std::ranges::all_of(column.cells, [](auto& text) { return text == kAbsent; });
    if (!empty) all.push_back(std::move(column));
  };
  const auto number = [&](const std::string& header, int importance, std::string (*text)(double),
                          const auto& value) {
    add({"", header, false, importance}, [&](const Solution& s) -> std::string {
      const double x = value(s);
      return std::isfinite(x) ? text(x) : kAbsent;
    });
  };
  const auto of_density = [](const Solution& s, double value) {
    return s.has_density() ? value : std::numeric_limits<double>::quiet_NaN();
  };
  add({"", "solution", true, kAlwaysShown}, [](const Solution& s) { return s.id(); });
  add({"", "solves", true, kSolves},
      [](const Solution& s) { return transform::solves_text(s.identity); });
  add(status_column(), [](const Solution& s) { return std::string(name(s.status)); });
  number("E[y^2]", kMoments, moment_text,
         [&](const Solution& s) { return of_density(s, s.moments.y2); });
  number("E[y'^2]", kMoments, moment_text,
         [&](const Solution& s) { return of_density(s, s.moments.v2); });
  for (const double wall : walls_of_rest(one)) {
    number(rest_header(one, wall), kAlwaysShown, moment_text,
           [&](const Solution& s) { return probability_of_rest(s, wall); });
  }
  int importance = kAlwaysShown;
  for (const Solution* reference : references(one)) {
    for (const auto variable : transform::kVariables) {
      const char* header = variable == transform::Variable::y ? "p(y)" : "p(y')";
      add({"L1 to " + reference->id(), header, false, importance},
          [&](const Solution& s) -> std::string {
            const auto l1 = one.l1(s.id(), reference->id(), variable);
            return l1 ? l1_text(*l1) : kAbsent;
          });
    }
    importance = kOtherReference;
  }
  number("energy", kEnergy, energy_text,
         [&](const Solution& s) { return of_density(s, s.energy_residual); });
  number("sec", kSeconds, seconds_text, [](const Solution& s) { return s.seconds; });
  return all;
}

std::string reasons_text(const results::Case& one, std::size_t width) {
  std::string text;
  for (const auto& [solutions, status, reason] : reasons(one)) {
    text += wrapped(fmt::format("  {} {}: {}", fmt::join(solutions, ", "), name(status), reason),
                    width, 4);
  }
  return text;
}

}  // namespace

std::string case_title(const problem::Problem& problem) {
  return fmt::format("{}: {}", problem.name, problem::parameters_text(problem));
}

std::string table(const results::Run& run, const TextFormat& format) {
  const std::size_t width = format.width;
  const Verdict said = verdict(run);
  std::string text = answer_text(said, format);
  if (!text.empty()) text += '\n';
  std::vector<Column> all, budgets;
  std::string missing;
  for (const auto& one : run.cases) {
    const auto all_columns = columns(one);
    const auto shown = fitting(all_columns, format);
    if (missing.empty()) missing = left_out(all_columns, shown);
    text += wrapped(case_title(one.problem), width, 2) + rows(shown, format) +
            reasons_text(one, width) + budget_table(one, format);
    for (const auto& sentence : findings(one)) text += wrapped("  " + sentence, width, 2);
    text += '\n';
    std::ranges::copy(shown, std::back_inserter(all));
    std::ranges::move(budget_columns(one, format), std::back_inserter(budgets));
  }
  if (!run.stopped.empty()) text += wrapped(run.stopped, width) + '\n';
  if (!missing.empty()) {
    text += wrapped(fmt::format("Omitted at {} characters per line: {}. A wider terminal, "
                                "report.html and summary.json show these columns.",
                                width, missing),
                    width);
  }
  for (const auto& legend : {results_legend(all, run), budget_legend(budgets)}) {
    if (!legend.empty()) text += wrapped(legend, width);
  }
  if (const auto last = verdict_text(run, said, format); !last.empty()) text += '\n' + last;
  return text;
}

}  // namespace fpkcheck::report
