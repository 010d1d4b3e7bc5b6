#include "report/verdict/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "compare/solution_assessment.hpp"

namespace fpkcheck::report {
namespace {

using results::case_count_over_solutions;
using results::CaseNamesBySolution;
using results::RunAssessment;
using transform::SolutionRole;

using Words = std::vector<std::string>;

std::string comma_separated(const Words& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

// Returns the ids of solutions: "mcs", or "mcs (fd-kf in case2)" if the cases have different
// solutions.
std::string solution_ids_text(const CaseNamesBySolution& solutions) {
  const auto most = std::ranges::max_element(solutions, {},
                                             [](const auto& entry) { return entry.second.size(); });
  std::string text = most->first;
  for (const auto& [id, cases] : solutions) {
    if (id != most->first) text += fmt::format(" ({} in {})", id, comma_separated(cases));
  }
  return text;
}

std::string reference_sentence(const RunAssessment& assessed, int cases) {
  if (assessed.references.empty()) {
    return "There is no reference: no solution of the full problem has status ok. Only the error "
           "estimate of each solution is available.";
  }
  std::string text =
      fmt::format("The reference{} is {}",
                  case_count_text(case_count_over_solutions(assessed.references), cases),
                  solution_ids_text(assessed.references));
  const double y = assessed.reference_y_l1, ydot = assessed.reference_ydot_l1;
  if (std::isfinite(y + ydot)) {
    text += fmt::format(", with L1 error estimates of {:.1g} in p(y) and {:.1g} in p(y')", y, ydot);
  }
  if (assessed.confirmation_distances.has_any_distance()) {
    CaseNamesBySolution independent = assessed.confirming;
    for (const auto& [id, names] : assessed.contradicting)
      independent[id].insert(independent[id].end(), names.begin(), names.end());
    text += fmt::format(". The L1 distance of the independent solution {} to the reference is {}",
                        solution_ids_text(independent),
                        l1_distances_text(assessed.confirmation_distances));
  }
  return text + '.';
}

std::string closure_orders_text(const std::vector<const SolutionAgreementOverCases*>& members) {
  Words orders;
  for (const SolutionAgreementOverCases* row : members) {
    orders.push_back(fmt::format("{}", *row->identity->order));
  }
  return comma_separated(orders);
}

bool differs_by_order_in_family(const SolutionAgreementOverCases& row) {
  return transform::differs_by_order_in_family(*row.identity);
}

int closure_order(const SolutionAgreementOverCases* row) { return *row->identity->order; }

std::vector<std::vector<const SolutionAgreementOverCases*>> closure_families(
    const std::vector<SolutionAgreementOverCases>& all) {
  std::vector<std::vector<const SolutionAgreementOverCases*>> families;
  for (const auto& row : all) {
    if (!differs_by_order_in_family(row)) continue;
    const auto same = std::ranges::find_if(families, [&](const auto& members) {
      return members.front()->identity->family == row.identity->family &&
             members.front()->identity->formulation == row.identity->formulation;
    });
    if (same == families.end()) {
      families.push_back({&row});
    } else {
      same->push_back(&row);
    }
  }
  for (auto& members : families) std::ranges::stable_sort(members, {}, closure_order);
  return families;
}

// The paper's closure has the impact condition to first order in 1-r.
bool is_paper_closure(const SolutionAgreementOverCases& row) {
  return row.identity->method == "epc" && row.identity->impact == problem::ImpactCondition::delta;
}

bool is_reference_chosen_by_user(const SolutionAgreementOverCases& row) {
  return row.identity->role == SolutionRole::measurement;
}

bool is_single_external_density(const SolutionAgreementOverCases& row) {
  return transform::is_external(*row.identity) && !differs_by_order_in_family(row) &&
         !is_reference_chosen_by_user(row);
}

// Returns whether a row is that of an approximate density without an order, such as statistical
// linearisation.
bool is_closure_without_order(const SolutionAgreementOverCases& row) {
  return row.identity->role == SolutionRole::closure && !differs_by_order_in_family(row) &&
         !transform::is_external(*row.identity);
}

// Returns the text of the closure orders that reproduce the reference solutions: "epc-gaussian (the
// paper's closure) at n = 6, not at n = 2, 4, 8".
// @param any receives whether at least one order reproduces the references
std::string reproducing_orders_text(const std::vector<const SolutionAgreementOverCases*>& members,
                                    bool& any) {
  std::vector<const SolutionAgreementOverCases*> good, bad;
  for (const SolutionAgreementOverCases* row : members) {
    (row->reproduced_case_count() == row->case_count() ? good : bad).push_back(row);
  }
  any = !good.empty();
  const std::string subject =
      fmt::format("{}{}", members.front()->identity->family,
                  is_paper_closure(*members.front()) ? " (the paper's closure)" : "");
  if (good.empty()) return fmt::format("{} at n = {}", subject, closure_orders_text(members));
  return fmt::format("{} at n = {}{}", subject, closure_orders_text(good),
                     bad.empty() ? "" : fmt::format(", not at n = {}", closure_orders_text(bad)));
}

std::string reproduction_sentence(const std::vector<SolutionAgreementOverCases>& all, int cases) {
  Words yes, no;
  for (const auto& row : all) {
    if (!is_single_external_density(row)) continue;
    (row.reproduced_case_count() == row.case_count() ? yes : no).push_back(row.identity->id);
  }
  for (const auto& members : closure_families(all)) {
    bool any = false;
    const std::string text = reproducing_orders_text(members, any);
    (any ? yes : no).push_back(text);
  }
  for (const auto& row : all) {
    if (!is_closure_without_order(row)) continue;
    (row.reproduced_case_count() == row.case_count() ? yes : no).push_back(row.identity->id);
  }
  if (yes.empty() && no.empty()) return "";
  const std::string within = fmt::format("Within L1 {} of the reference{}", compare::kCloseL1,
                                         case_count_text(cases, cases));
  if (yes.empty()) return fmt::format("{}: none of {}.", within, fmt::join(no, "; "));
  return fmt::format("{}: {}{}.", within, fmt::join(yes, "; "),
                     no.empty() ? "" : fmt::format("; not {}", fmt::join(no, "; ")));
}

MethodVerdictLine verdict_line(const SolutionAgreementOverCases& row, const std::string& reference,
                               int cases) {
  return {row.identity->id, row.reproduced_case_count() == row.case_count(),
          solution_outcome_text(row, reference, cases)};
}

// Returns the verdict line with the largest distance for each order of a formulation: "n = 4 has L1
// distance 0.0089, 8 has 0.0017".
MethodVerdictLine verdict_line(const std::vector<const SolutionAgreementOverCases*>& members,
                               int cases) {
  Words parts;
  bool all = true, first = true;
  for (const SolutionAgreementOverCases* row : members) {
    all = all && row->reproduced_case_count() == row->case_count();
    const auto largest_l1_distance = row->largest_l1_distance();
    const std::string order = fmt::format("{}{}", first ? "n = " : "", *row->identity->order);
    parts.push_back(
        largest_l1_distance
            ? fmt::format("{} has {}{:.2g}", order, first ? "L1 distance " : "",
                          *largest_l1_distance)
            : fmt::format("{} is {}", order, outcome_text_without_distances(*row, cases)));
    first = false;
  }
  return {
      members.front()->identity->family, all,
      fmt::format("{}{}", all ? "reproduced: " : "reproduced in part: ", comma_separated(parts))};
}

std::vector<MethodVerdictLine> verdict_lines(const RunAssessment& assessed, int cases) {
  const auto& all = assessed.rows;
  const std::string reference = solution_ids_text(assessed.references);
  std::vector<MethodVerdictLine> lines;
  for (const auto& row : all) {
    if (is_single_external_density(row)) lines.push_back(verdict_line(row, reference, cases));
  }
  for (const auto& members : closure_families(all)) {
    if (members.size() > 1 && !is_paper_closure(*members.front())) {
      lines.push_back(verdict_line(members, cases));
    } else {
      for (const SolutionAgreementOverCases* row : members)
        lines.push_back(verdict_line(*row, reference, cases));
    }
  }
  for (const auto& row : all) {
    const bool solves_it =
        std::ranges::any_of(row.entries, [](const SolutionAgreementInCase& entry) {
          return entry.solution != nullptr && compare::is_solution_of_full_problem(*entry.solution);
        });
    const SolutionRole role = row.identity->role;
    if (solves_it || (role != SolutionRole::equation && role != SolutionRole::simulation &&
                      !is_closure_without_order(row))) {
      continue;
    }
    lines.push_back(verdict_line(row, reference, cases));
  }
  return lines;
}

std::string confirmation_text(const RunAssessment& assessed, int cases) {
  const auto &confirming = assessed.confirming, &contradicting = assessed.contradicting;
  if (!contradicting.empty()) {
    return fmt::format("{} differs by more than the errors of both explain{}",
                       solution_ids_text(contradicting),
                       case_count_text(case_count_over_solutions(contradicting), cases));
  }
  if (confirming.empty()) return "no independent solution in this run confirms these values";
  std::string text = fmt::format("{} confirms these values", solution_ids_text(confirming));
  if (case_count_over_solutions(confirming) == cases) return text;
  std::vector<std::string> names;
  for (const auto& [id, of_this] : confirming)
    names.insert(names.end(), of_this.begin(), of_this.end());
  return text + fmt::format(" in {} only", comma_separated(names));
}

Words recommendation_sentences(const RunAssessment& assessed, int cases) {
  if (const int judged = case_count_over_solutions(assessed.references); judged < cases) {
    return {fmt::format(
        "There is no reference{}: rely on the error estimate of each solution. Raise the "
        "limits of fd (--max-seconds) and mcs (--time), or compare both: fpkcheck run "
        "--methods fd,mcs.",
        case_count_text(cases - judged, cases))};
  }
  Words sentences;
  if (std::ranges::none_of(assessed.rows, is_reference_chosen_by_user)) {
    sentences.push_back(fmt::format(
        "For reference values use {}, the solution of the full problem (all jumps, exact impact) "
        "with the smallest error estimate; {}.",
        solution_ids_text(assessed.references), confirmation_text(assessed, cases)));
  }
  Words parts;
  const SolutionAgreementOverCases* last = nullptr;
  for (const double accuracy : {0.01, 0.001}) {
    const SolutionAgreementOverCases* found = assessed.fastest_accurate_solution(accuracy);
    if (found == nullptr || found == last) continue;
    parts.push_back(fmt::format("within L1 {}{}, {} ({:.2g} s)", accuracy,
                                parts.empty() ? case_count_text(cases, cases) : "",
                                found->identity->id, found->longest_solve_seconds()));
    last = found;
  }
  if (!parts.empty()) {
    sentences.push_back(
        fmt::format("Fastest solution with status ok: {}.", fmt::join(parts, "; ")));
  }
  return sentences;
}

}  // namespace

RunVerdict make_run_verdict(const results::Run& run) {
  const int cases = static_cast<int>(run.cases.size());
  RunAssessment assessed = results::assess_run(run);
  RunVerdict run_verdict{.agreement_rows = {}, .answer = {}, .lines = {}, .recommendation = {}};
  if (cases == 0) return run_verdict;
  for (const auto& case_result : run.cases) {
    if (!case_result.bounds) continue;
    for (const auto& outside :
         compare::violations_beyond_error_estimate(*case_result.bounds, case_result.solutions)) {
      run_verdict.answer.push_back(
          fmt::format("{}: {} is wrong, its {} contradicts the guaranteed bounds.",
                      case_result.name(), outside.solution->id(), outside.bound->functional));
    }
  }
  run_verdict.answer.push_back(reference_sentence(assessed, cases));
  if (!assessed.references.empty()) {
    if (auto text = reproduction_sentence(assessed.rows, cases); !text.empty())
      run_verdict.answer.push_back(text);
    run_verdict.lines = verdict_lines(assessed, cases);
  }
  run_verdict.recommendation = recommendation_sentences(assessed, cases);
  run_verdict.agreement_rows = std::move(assessed.rows);
  return run_verdict;
}

}  // namespace fpkcheck::report
