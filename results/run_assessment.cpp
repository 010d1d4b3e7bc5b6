#include "results/run_assessment.hpp"

#include <algorithm>

namespace fpkcheck::results {

using compare::AgreementWithReference;

namespace {

std::optional<double> larger_of(std::optional<double> one, std::optional<double> other) {
  if (one && other) return std::max(*one, *other);
  return one ? one : other;
}

SolutionAgreementInCase agreement_in_case(const results::CaseResult& one, std::string_view id) {
  const auto* assessed = one.assessment.find_solution_assessment(id);
  return assessed == nullptr ? SolutionAgreementInCase{}
                             : SolutionAgreementInCase{{*assessed}, one.find(id)};
}

std::vector<SolutionAgreementOverCases> agreement_rows(const results::Run& run) {
  std::vector<SolutionAgreementOverCases> all;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    auto place = all.begin();
    for (const auto& solution : run.cases[k].solutions) {
      const auto known =
          std::ranges::find(all, solution.id(),
                            [](const SolutionAgreementOverCases& row) { return row.identity->id; });
      if (known != all.end()) {
        place = known + 1;
        continue;
      }
      // A row for a new solution is inserted after the row of the preceding solution of the case.
      place = all.insert(place, SolutionAgreementOverCases{&solution.identity, {}}) + 1;
    }
  }
  for (auto& row : all) {
    for (const auto& one : run.cases) {
      row.entries.push_back(agreement_in_case(one, row.identity->id));
    }
  }
  // A solution that is not applicable in any case gets no row in the assessment.
  std::erase_if(all, [](const SolutionAgreementOverCases& row) {
    return std::ranges::all_of(row.entries, [](const SolutionAgreementInCase& entry) {
      return entry.solution == nullptr || entry.solution->status == transform::Status::not_offered;
    });
  });
  return all;
}

}  // namespace

int SolutionAgreementOverCases::case_count() const {
  return static_cast<int>(entries.size()) -
         case_count_with_agreement(AgreementWithReference::absent);
}

int SolutionAgreementOverCases::reproduced_case_count() const {
  return static_cast<int>(
      std::ranges::count_if(entries, &SolutionAgreementInCase::reproduces_reference));
}

int SolutionAgreementOverCases::case_count_with_agreement(AgreementWithReference agreement) const {
  return static_cast<int>(
      std::ranges::count(entries, agreement, &SolutionAgreementInCase::agreement));
}

std::optional<double> SolutionAgreementOverCases::largest_l1_distance_of_marginal(
    std::optional<double> SolutionAgreementInCase::*marginal) const {
  std::optional<double> most;
  for (const auto& entry : entries) {
    if (entry.agreement != AgreementWithReference::no_density)
      most = larger_of(most, entry.*marginal);
  }
  return most;
}

std::optional<double> SolutionAgreementOverCases::largest_l1_distance() const {
  return larger_of(largest_l1_distance_of_marginal(&SolutionAgreementInCase::y),
                   largest_l1_distance_of_marginal(&SolutionAgreementInCase::ydot));
}

double SolutionAgreementOverCases::longest_solve_seconds() const {
  double longest = 0;
  for (const auto& entry : entries) {
    if (entry.solution != nullptr) longest = std::max(longest, entry.solution->seconds);
  }
  return longest;
}

void MarginalDistances::update_largest_l1_distances(const std::optional<double>& other_y,
                                                    const std::optional<double>& other_ydot) {
  y = larger_of(y, other_y);
  ydot = larger_of(ydot, other_ydot);
}

int case_count_over_solutions(const CaseNamesBySolution& cases) {
  std::size_t count = 0;
  for (const auto& [id, names] : cases) count += names.size();
  return static_cast<int>(count);
}

const SolutionAgreementOverCases* RunAssessment::fastest_accurate_solution(double accuracy) const {
  const double error = std::max(reference_y_l1, reference_ydot_l1);
  const SolutionAgreementOverCases* fastest = nullptr;
  for (const auto& row : rows) {
    const bool is_accurate =
        std::ranges::all_of(row.entries, [&](const SolutionAgreementInCase& entry) {
          if (entry.agreement == AgreementWithReference::reference) return error <= accuracy;
          return entry.solution != nullptr && entry.solution->has_status_ok() && entry.y &&
                 entry.ydot && *entry.largest_l1_distance() + error <= accuracy;
        });
    if (!is_accurate || transform::is_external(*row.identity)) continue;
    if (fastest == nullptr || row.longest_solve_seconds() < fastest->longest_solve_seconds())
      fastest = &row;
  }
  return fastest;
}

RunAssessment assess_run(const Run& run) {
  RunAssessment assessed{.rows = agreement_rows(run)};
  for (const auto& case_result : run.cases) {
    const auto& assessment = case_result.assessment;
    if (assessment.reference.empty()) continue;
    assessed.references[assessment.reference].push_back(case_result.name());
    assessed.reference_y_l1 = std::max(assessed.reference_y_l1, assessment.reference_y_l1);
    assessed.reference_ydot_l1 = std::max(assessed.reference_ydot_l1, assessment.reference_ydot_l1);
    const auto& second = assessment.confirmation;
    if (!second) continue;
    (second->has_agreement ? assessed.confirming : assessed.contradicting)[second->id].push_back(
        case_result.name());
    const auto& distances = *assessment.find_solution_assessment(second->id);
    assessed.confirmation_distances.update_largest_l1_distances(distances.y, distances.ydot);
  }
  return assessed;
}

}  // namespace fpkcheck::results
