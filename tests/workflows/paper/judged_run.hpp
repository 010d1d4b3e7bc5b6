#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "made_up_solutions.hpp"
#include "workflows/paper/judge_claims.hpp"

/// Runs of the paper's cases with invented solutions and distances that the tests choose.
namespace fpkcheck::tests {

/// Error budgets of the closures n = 2, 4, 6 to `mcs`, all with these distances.
inline results::Run run_with_distances(double l1 = 0.01, double tail = 0.1) {
  // Shared by the tests; each test changes its own copy.
  static const results::CaseResult made_up = made_up_case();
  results::Run run{results::current_program("fpkcheck paper"), {4, made_up}};
  for (int number = 1; number <= 4; ++number) {
    auto& problem = run.cases[static_cast<std::size_t>(number) - 1].problem;
    problem = paper_case(number);
    problem.name = paper::paper_case_name(number);
  }
  for (auto& one : run.cases) {
    for (auto& row : one.budget) {
      row.total = l1;
      row.total_tail = tail;
      row.tail_bins = 9;
      for (auto& part : row.parts) part.tail = 0;
    }
  }
  return run;
}

inline results::CaseResult& case_in(results::Run& run, int number) {
  return run.cases.at(static_cast<std::size_t>(number) - 1);
}

inline compare::ErrorBudgetRow& budget_row(results::Run& run, int number, int order,
                                           transform::StateVariable variable) {
  for (auto& row : case_in(run, number).budget) {
    if (row.solution == paper::paper_closure_id(order) && row.variable == variable) return row;
  }
  throw std::logic_error("no such row");
}

inline transform::Solution& closure(results::Run& run, int number, int order) {
  for (auto& one : case_in(run, number).solutions) {
    if (one.id() == paper::paper_closure_id(order)) return one;
  }
  throw std::logic_error("no such closure");
}

/// The judgement of a claim, by the number of its case (0: all four) and its text.
inline paper::PaperClaimJudgement find_judgement(const results::Run& run, int number,
                                                 const std::string& claim_text) {
  for (const auto& one : paper::judge_claims(run)) {
    const auto& cases = one.claim.cases;
    const bool is_here = number == 0 ? cases.size() == 4 : cases == std::vector<int>{number};
    if (is_here && paper::claim_text(one.claim) == claim_text) return one;
  }
  throw std::logic_error("no claim '" + claim_text + "'");
}

}  // namespace fpkcheck::tests
