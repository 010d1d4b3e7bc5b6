#include "report/verdict/agreement.hpp"

#include <algorithm>

namespace fpkcheck::report {
namespace {

std::optional<double> larger_of(std::optional<double> one, std::optional<double> other) {
  if (one && other) return std::max(*one, *other);
  return one ? one : other;
}

}  // namespace

AgreementEntry agreement_entry(const results::CaseResult& one, std::string_view id) {
  const auto* assessed = one.assessment.find(id);
  return assessed == nullptr ? AgreementEntry{} : AgreementEntry{{*assessed}, one.find(id)};
}

int AgreementRow::case_count() const {
  return static_cast<int>(entries.size()) - case_count_with(Agreement::absent);
}

int AgreementRow::reproduced_case_count() const {
  return static_cast<int>(std::ranges::count_if(entries, &AgreementEntry::reproduces_reference));
}

int AgreementRow::case_count_with(Agreement agreement) const {
  return static_cast<int>(std::ranges::count(entries, agreement, &AgreementEntry::agreement));
}

std::optional<double> AgreementRow::largest_l1_of(
    std::optional<double> AgreementEntry::*marginal) const {
  std::optional<double> most;
  for (const auto& entry : entries) {
    if (entry.agreement != Agreement::no_density) most = larger_of(most, entry.*marginal);
  }
  return most;
}

std::optional<double> AgreementRow::largest_l1() const {
  return larger_of(largest_l1_of(&AgreementEntry::y), largest_l1_of(&AgreementEntry::ydot));
}

double AgreementRow::longest_seconds() const {
  double longest = 0;
  for (const auto& entry : entries) {
    if (entry.solution != nullptr) longest = std::max(longest, entry.solution->seconds);
  }
  return longest;
}

std::vector<AgreementRow> agreement_rows(const results::Run& run) {
  std::vector<AgreementRow> all;
  for (std::size_t k = 0; k < run.cases.size(); ++k) {
    auto place = all.begin();
    for (const auto& solution : run.cases[k].solutions) {
      const auto known = std::ranges::find(
          all, solution.id(), [](const AgreementRow& row) { return row.identity->id; });
      if (known != all.end()) {
        place = known + 1;
        continue;
      }
      // A new row is inserted behind the row of the preceding solution in the first case that has
      // the new solution.
      place = all.insert(place, AgreementRow{&solution.identity, {}}) + 1;
    }
  }
  for (auto& row : all) {
    for (const auto& one : run.cases) {
      row.entries.push_back(agreement_entry(one, row.identity->id));
    }
  }
  // A solution that is not applicable to any case has no row.
  std::erase_if(all, [](const AgreementRow& row) {
    return std::ranges::all_of(row.entries, [](const AgreementEntry& entry) {
      return entry.solution == nullptr || entry.solution->status == transform::Status::not_offered;
    });
  });
  return all;
}

}  // namespace fpkcheck::report
