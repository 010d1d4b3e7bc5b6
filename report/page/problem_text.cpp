#include "report/page/problem_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "compare/reference.hpp"
#include "report/page/families.hpp"
#include "report/page/html.hpp"
#include "report/page/number_text.hpp"
#include "report/references.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;
using transform::Variable;

constexpr const char* kProblem =
    R"html(<p>A particle on a hardening spring bounces off a wall at its equilibrium position and is kicked by random
impulses:</p>
<p class="formula">y″ + c y′ + k y + μ y³ = Σ<sub>k</sub> Y<sub>k</sub> δ(t − τ<sub>k</sub>) &nbsp; for y &gt; 0,
&emsp; y′<sub>+</sub> = −r y′<sub>−</sub> &nbsp; at y = 0.</p>
<p>The impulses arrive as a Poisson process of rate λ; their amplitudes Y are independent and follow one law. Sought is the
stationary probability density p(y, y′) of displacement and velocity, and from it p(y) and p(y′). All quantities are
non-dimensional.</p>
)html";

constexpr const char* kColumns =
    R"html(<dt>L1</dt><dd>Integral of |p − other p|: 0 for equal densities, 2 for disjoint ones.</dd>
<dt>energy residual</dt><dd>Of the balance of power between impulses, damping and impacts, relative to the input.</dd>
)html";

constexpr const char* kUncertainty =
    R"html(<dt>±</dt><dd>Discretisation errors of both ends of a step, added: a part below it may be nought. If all else is right,
the step to the simulation is chance alone, which makes the mean L1 of the last columns; to a simulation without noise it is the
discretisation as measured, over smooth bins.</dd>
)html";

std::string term(std::string_view name, const std::string& meaning) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(meaning));
}

/// The solutions of all cases, the first of each id.
std::vector<const Solution*> distinct_solutions(const results::Run& run) {
  std::vector<const Solution*> all;
  for (const auto& one : run.cases) {
    for (const auto& solution : one.solutions) {
      if (std::ranges::find(all, solution.id(), &Solution::id) == all.end()) {
        all.push_back(&solution);
      }
    }
  }
  return all;
}

std::string families_html(const std::vector<const Solution*>& solutions) {
  std::string html;
  for (const auto& [name, members] : families(solutions)) {
    std::vector<std::string> ids;
    for (const Solution* member : members) ids.push_back(member->id());
    html += term(fmt::format("{}", fmt::join(ids, ", ")), members.front()->identity.meaning);
  }
  return html;
}

// The values of an enum that some solution has, under "solves".
template <class Enum>
std::string solved_html(const std::vector<const Solution*>& solutions,
                        std::optional<Enum> transform::Identity::*member, const char* form,
                        const char* what) {
  std::string html;
  for (const auto& [value, name, meaning] : names(Enum{})) {
    const bool there = std::ranges::any_of(
        solutions, [&, value = value](const Solution* s) { return s->identity.*member == value; });
    if (there) {
      html += term(fmt::format(fmt::runtime(form), name), fmt::format("{}: {}.", what, meaning));
    }
  }
  return html;
}

std::string statuses_html() {
  std::string html = "<dt>status</dt><dd>";
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    html += fmt::format("{}<b>{}</b>", status == transform::Status::ok ? "" : "; ", name);
    if (!meaning.empty()) html += ": " + escaped(meaning);
  }
  return html + ".</dd>\n";
}

std::string parts_html() {
  std::string html = "<p id=\"budget-terms\">Parts of an error budget:</p>\n<dl>\n";
  for (const auto& [link, name, meaning] : compare::kLinkNames) {
    html += term(name, fmt::format("{}.", meaning));
  }
  return html + kUncertainty + "</dl>\n";
}

// "λ, impulses per unit of time"; a word has no symbol.
std::string label(const problem::ShownParameter& parameter) {
  return parameter.typeset.empty() ? parameter.meaning
                                   : parameter.typeset + ", " + parameter.meaning;
}

/// Closures of which none can be called closer to the reference than another, and the others
/// farther away.
std::vector<compare::Rank> closest_closures(const results::Case& one, const Solution& reference) {
  auto ranks = compare::closures_by_distance(one.solutions, one.pairs);
  std::erase_if(ranks, [&, first = ranks.empty() ? compare::Rank{}
                                                 : ranks.front()](const compare::Rank& rank) {
    return rank.solution != first.solution && !compare::indistinguishable(first, rank, reference);
  });
  return ranks;
}

std::string names_of(const std::vector<compare::Rank>& ranks) {
  if (ranks.empty()) return std::string(kNoValue);
  std::vector<std::string> ids;
  for (const auto& rank : ranks) ids.push_back(rank.solution->id());
  return fmt::format("{}{}", ids.size() > 1 ? "indistinguishable: " : "", fmt::join(ids, ", "));
}

// "0.00120", or from the least to the largest.
std::string l1_of(const std::vector<compare::Rank>& ranks, double compare::Rank::*member) {
  if (ranks.empty()) return std::string(kNoValue);
  const auto [least, most] = std::ranges::minmax(ranks, {}, member);
  const std::string from = l1_cell(least.*member), to = l1_cell(most.*member);
  return from == to ? from : from + " to " + to;
}

}  // namespace

std::string problem_html(const results::Run& run) {
  // All problems have the same parameters.
  std::vector<HtmlColumn> columns{{"parameter", Align::left}};
  for (const auto& one : run.cases) {
    columns.push_back({one.name()});
    columns.front().cells.clear();
    for (const auto& parameter : problem::shown_parameters(one.problem)) {
      columns.front().cells.push_back(label(parameter));
      columns.back().cells.push_back(value_text(parameter.value));
    }
  }
  return kProblem + table_html("The numbers", std::move(columns));
}

std::string glossary_html(const results::Run& run) {
  using transform::Identity;
  const auto solutions = distinct_solutions(run);
  std::string html = "<dl>\n" + families_html(solutions);
  html += solved_html(solutions, &Identity::equation, "solves {}/\u2026", "Excitation");
  html += solved_html(solutions, &Identity::impact, "solves \u2026/{}", "Impact");
  const auto given = std::ranges::find_if(
      solutions, [](const Solution* s) { return !s->identity.equation || !s->identity.impact; });
  if (given != solutions.end()) {
    html += term("solves " + solves_text((*given)->identity),
                 "Its equation or its impact is not known.");
  }
  return html + kColumns + statuses_html() + "</dl>\n" + parts_html();
}

std::string overview_table(const results::Run& run) {
  std::vector<HtmlColumn> columns{
      {"case", Align::left}, {"reference", Align::left},       {"E[y\u00b2]"},
      {"E[y\u2032\u00b2]"},  {"checked by", Align::left},      {"its L1 to the reference, p(y)"},
      {"p(y\u2032)"},        {"closest closure", Align::left}, {"its L1 to the reference, p(y)"},
      {"p(y\u2032)"}};
  for (const auto& one : run.cases) {
    const std::string none(kNoValue);
    std::vector<std::string> cells(columns.size(), none);
    cells[0] = one.name();
    const auto all = references(one);
    if (!all.empty()) {
      const Solution* reference = all.front();
      cells[1] = reference->id();
      cells[2] = number_text(reference->moments.y2, 4);
      cells[3] = number_text(reference->moments.v2, 4);
      if (all.size() > 1) {
        const std::string& second = all.back()->id();
        cells[4] = second;
        cells[5] = l1_cell(one.l1(second, reference->id(), Variable::y));
        cells[6] = l1_cell(one.l1(second, reference->id(), Variable::ydot));
      }
      const auto closest = closest_closures(one, *reference);
      cells[7] = names_of(closest);
      cells[8] = l1_of(closest, &compare::Rank::y);
      cells[9] = l1_of(closest, &compare::Rank::ydot);
    }
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c].cells.push_back(cells[c]);
  }
  return table_html("What came out", std::move(columns));
}

std::string timings_table(const results::Run& run) {
  std::vector<HtmlColumn> columns{{"solution", Align::left}};
  for (const Solution* solution : distinct_solutions(run)) {
    columns.front().cells.push_back(solution->id());
  }
  for (const auto& one : run.cases) {
    HtmlColumn column{one.name()};
    double all = 0;
    for (const auto& id : columns.front().cells) {
      const Solution* solution = one.find(id);
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
