#include "report/verdict/agreement.hpp"

#include <algorithm>
#include <cmath>

#include "compare/reference.hpp"

namespace fpkcheck::report {
namespace {

using transform::Solution;
using transform::Status;
using transform::Variable;

std::optional<double> larger_of(std::optional<double> one, std::optional<double> other) {
  if (one && other) return std::max(*one, *other);
  return one ? one : other;
}

// Whether the distances are at most the error estimate of the reference, and thus not significant.
bool is_within_reference_error(const Solution& reference, const AgreementEntry& entry) {
  const auto within = [&](const std::optional<double>& l1, Variable variable) {
    const double known = compare::l1_error_estimate(reference, variable);
    return !l1 || (std::isfinite(known) && *l1 <= known);
  };
  return within(entry.y, Variable::y) && within(entry.ydot, Variable::ydot);
}

}  // namespace

std::optional<double> AgreementEntry::largest_l1() const { return larger_of(y, ydot); }

bool AgreementEntry::reproduces_reference() const {
  return agreement == Agreement::reference || agreement == Agreement::indistinguishable ||
         agreement == Agreement::close;
}

AgreementEntry agreement_entry(const results::CaseResult& one, std::string_view id) {
  AgreementEntry entry{.solution = one.find(id)};
  if (entry.solution == nullptr) return entry;
  const Solution* reference = compare::select_reference(one.solutions);
  if (reference == entry.solution) {
    entry.agreement = Agreement::reference;
    return entry;
  }
  if (reference != nullptr) {
    entry.y = one.l1(id, reference->id(), Variable::y);
    entry.ydot = one.l1(id, reference->id(), Variable::ydot);
  }
  const bool is_density =
      entry.solution->has_density() && entry.solution->status != Status::inadmissible;
  if (!is_density) {
    entry.agreement = Agreement::no_density;
  } else if (!entry.largest_l1()) {
    entry.agreement = Agreement::no_reference;
  } else if (is_within_reference_error(*reference, entry)) {
    entry.agreement = Agreement::indistinguishable;
  } else {
    entry.agreement = *entry.largest_l1() <= kCloseL1 ? Agreement::close : Agreement::distant;
  }
  return entry;
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
