#include "report/page/page_sections.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "report/case_solutions.hpp"
#include "report/page/html_elements.hpp"
#include "report/text/number_text.hpp"

namespace fpkcheck::report {
namespace {

using problem::Problem;
using problem::ReportedParameter;
using transform::Solution;

constexpr const char* kColumnDefinitions =
    R"html(<dt>L1</dt>
<dd>Integral of the absolute difference of two densities: 0 for equal, 2 for disjoint densities.</dd>
<dt>energy residual</dt>
<dd>Residual of the power balance of impulses, damping and impacts, relative to the input.</dd>
)html";

constexpr const char* kUncertaintyDefinition =
    R"html(<dt>±</dt><dd>Sum of the discretisation errors of both ends of a step: a smaller part may be
zero. The step to a simulation is sampling error alone if all else is exact; the last columns have the
mean and the 99 % quantile of this L1. The step to a simulation with control variates is the measured
discretisation error over smooth bins.</dd>
)html";

std::string definition_html(std::string_view name, const std::string& meaning) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escape_html(name), escape_html(meaning));
}

/// Returns one solution for each id that occurs in a run: the first solution with this id.
std::vector<const Solution*> distinct_solutions(const results::Run& run) {
  std::vector<const Solution*> all;
  for (const auto& case_result : run.cases) {
    for (const auto& solution : case_result.solutions) {
      if (std::ranges::find(all, solution.id(), &Solution::id) == all.end()) {
        all.push_back(&solution);
      }
    }
  }
  return all;
}

std::string solution_families_html(const std::vector<const Solution*>& solutions) {
  std::string html;
  for (const auto& [name, members] : group_by_family(solutions)) {
    std::vector<std::string> ids;
    for (const Solution* member : members) ids.push_back(member->id());
    html +=
        definition_html(fmt::format("{}", fmt::join(ids, ", ")), members.front()->identity.meaning);
  }
  return html;
}

template <class Enum>
std::string model_terms_html(const std::vector<const Solution*>& solutions,
                             std::optional<Enum> transform::SolutionIdentity::*member,
                             const char* form, const char* what) {
  std::string html;
  for (const auto& [value, name, meaning] : enumerator_names(Enum{})) {
    const bool there = std::ranges::any_of(solutions, [&, sought = value](const Solution* s) {
      return s->identity.*member == sought;
    });
    if (there) {
      html += definition_html(fmt::format(fmt::runtime(form), name),
                              fmt::format("{}: {}.", what, meaning));
    }
  }
  return html;
}

std::string statuses_html() {
  std::string html = "<dt>status</dt><dd>";
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    html += fmt::format("{}<b>{}</b>", status == transform::Status::ok ? "" : "; ", name);
    if (!meaning.empty()) html += ": " + escape_html(meaning);
  }
  return html + ".</dd>\n";
}

std::string budget_parts_html() {
  std::string html = "<p id=\"budget-terms\">Parts of an error budget:</p>\n<dl>\n";
  for (const auto& [approximation, name, meaning] : compare::kApproximationNames) {
    html += definition_html(name, fmt::format("{}.", meaning));
  }
  return html + kUncertaintyDefinition + "</dl>\n";
}

// Returns the value of a parameter in another problem; empty if the other problem lacks the
// parameter.
std::optional<base::Value> value_in_problem(const Problem& other,
                                            const ReportedParameter& parameter) {
  for (const auto& candidate : problem::parameters_for_reports(other)) {
    if (candidate.section == parameter.section && candidate.name == parameter.name) {
      return candidate.value;
    }
  }
  return std::nullopt;
}

bool varies_between_cases(const results::Run& run, const ReportedParameter& parameter) {
  return std::ranges::any_of(run.cases, [&](const results::CaseResult& case_result) {
    return value_in_problem(case_result.problem, parameter) != parameter.value;
  });
}

// Returns the symbol and the meaning of a parameter, "λ, impulses per unit of time", or only the
// meaning.
std::string parameter_label(const ReportedParameter& parameter) {
  return parameter.typeset.empty() ? parameter.meaning
                                   : parameter.typeset + ", " + parameter.meaning;
}

}  // namespace

std::string problem_description_html(const results::Run& run) {
  std::vector<HtmlTableColumn> columns{{"parameter", TextAlignment::left}};
  for (const auto& case_result : run.cases) columns.push_back({case_result.name()});
  std::vector<std::string> same;
  if (!run.cases.empty()) {
    for (const auto& parameter : problem::parameters_for_reports(run.cases.front().problem)) {
      if (!varies_between_cases(run, parameter)) {
        same.push_back(fmt::format("{} = {}", parameter_label(parameter),
                                   parameter_value_text(parameter.value)));
        continue;
      }
      columns.front().cells.push_back(parameter_label(parameter));
      for (std::size_t k = 0; k < run.cases.size(); ++k) {
        const auto value = value_in_problem(run.cases[k].problem, parameter);
        columns[k + 1].cells.push_back(value ? parameter_value_text(*value)
                                             : std::string(kNoValue));
      }
    }
  }
  std::vector<const Problem*> problems;
  for (const auto& case_result : run.cases) problems.push_back(&case_result.problem);
  std::string html = problem_statement(problems);
  if (!same.empty()) {
    html += html_element(
        "p", fmt::format("{}: {}.", run.cases.size() > 1 ? "Parameters of all cases" : "Parameters",
                         fmt::join(same, "; ")));
  }
  return html + table_html("Parameters that differ between cases", std::move(columns));
}

std::string varying_parameters_text(const results::Run& run,
                                    const results::CaseResult& case_result) {
  std::vector<std::string> parts;
  for (const auto& parameter : problem::parameters_for_reports(case_result.problem)) {
    if (!varies_between_cases(run, parameter)) continue;
    const std::string& symbol = parameter.typeset.empty() ? parameter.meaning : parameter.typeset;
    parts.push_back(fmt::format("{} = {}", symbol, parameter_value_text(parameter.value)));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string glossary_html(const results::Run& run) {
  using transform::SolutionIdentity;
  const auto solutions = distinct_solutions(run);
  std::string html = "<dl>\n" + solution_families_html(solutions);
  html +=
      model_terms_html(solutions, &SolutionIdentity::equation, "solves {}/\u2026", "Excitation");
  html += model_terms_html(solutions, &SolutionIdentity::impact, "solves \u2026/{}", "Impact");
  const auto given = std::ranges::find_if(
      solutions, [](const Solution* s) { return !s->identity.equation || !s->identity.impact; });
  if (given != solutions.end()) {
    html += definition_html("solves " + equation_and_impact_text((*given)->identity),
                            "The equation or the impact is unknown.");
  }
  return html + kColumnDefinitions + statuses_html() + "</dl>\n" + budget_parts_html();
}

std::string timings_table_html(const results::Run& run) {
  std::vector<HtmlTableColumn> columns{{"solution", TextAlignment::left}};
  for (const Solution* solution : distinct_solutions(run)) {
    columns.front().cells.push_back(solution->id());
  }
  for (const auto& case_result : run.cases) {
    HtmlTableColumn column{case_result.name()};
    double all = 0;
    for (const auto& id : columns.front().cells) {
      const Solution* solution = case_result.find(id);
      if (solution != nullptr && std::isfinite(solution->seconds)) all += solution->seconds;
      column.cells.push_back(
          seconds_text(solution ? std::optional(solution->seconds) : std::nullopt));
    }
    column.cells.push_back(seconds_text(all));
    columns.push_back(std::move(column));
  }
  columns.front().cells.emplace_back("all");
  return table_html("Seconds per solution", std::move(columns));
}

}  // namespace fpkcheck::report
