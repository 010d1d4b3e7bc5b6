#include "report/verdict/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace fpkcheck::report {
namespace {

using transform::Status;

constexpr std::pair<Status, char> kStatusMarks[] = {
    {Status::inaccurate, '~'}, {Status::inadmissible, '!'}, {Status::not_converged, 'x'},
    {Status::ill_posed, 'i'},  {Status::failed, 'f'},       {Status::not_offered, '-'},
};
constexpr char kSame = '=', kNone = ' ';

std::string_view status_meaning(Status status) {
  switch (status) {
    case Status::not_converged:
      return "no solution found";
    case Status::inadmissible:
      return "no probability density";
    case Status::ill_posed:
      return "the discrete solution grows without bound";
    case Status::not_offered:
      return "the method does not apply to the problem";
    default:
      return "the solver broke down";
  }
}

// Returns a text on the largest L1 distances over the cases with a given agreement: "L1 distance up
// to .. in 2 of 4 cases".
std::string largest_distance_text(const SolutionAgreementOverCases& row,
                                  AgreementWithReference agreement, const char* how, int cases) {
  MarginalDistances most{};
  for (const auto& entry : row.entries) {
    if (entry.agreement == agreement) most.update_largest_l1_distances(entry.y, entry.ydot);
  }
  const int count = row.case_count_with_agreement(agreement);
  return fmt::format("L1 distance {}{}{}", cases == 1 ? "" : how, l1_distances_text(most),
                     count == cases ? "" : case_count_text(count, cases));
}

std::vector<std::string> missing_density_texts(const SolutionAgreementOverCases& row, int cases) {
  std::vector<std::string> parts;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    const auto count =
        std::ranges::count_if(row.entries, [sought = status](const SolutionAgreementInCase& entry) {
          return entry.agreement == AgreementWithReference::no_density &&
                 entry.solution->status == sought;
        });
    if (count == 0) continue;
    parts.push_back(fmt::format("{}{}: {}", name, case_count_text(static_cast<int>(count), cases),
                                status_meaning(status)));
  }
  return parts;
}

}  // namespace

std::string l1_distances_text(const MarginalDistances& distances) {
  const auto& [y, ydot] = distances;
  if (!ydot) return fmt::format("{:.2g} in p(y)", y.value_or(0));
  if (!y) return fmt::format("{:.2g} in p(y')", *ydot);
  return fmt::format("{:.2g} in p(y) and {:.2g} in p(y')", *y, *ydot);
}

std::string case_count_text(int count, int cases) {
  if (cases == 1) return "";
  if (count == cases) return fmt::format(" in {} {} cases", cases == 2 ? "both of" : "all", cases);
  return fmt::format(" in {} of {} cases", count, cases);
}

std::string solution_outcome_text(const SolutionAgreementOverCases& row,
                                  const std::string& reference, int cases) {
  const int close = row.case_count_with_agreement(AgreementWithReference::close);
  const int same = row.case_count_with_agreement(AgreementWithReference::indistinguishable) +
                   row.case_count_with_agreement(AgreementWithReference::reference);
  std::vector<std::string> parts;
  if (same > 0) {
    parts.push_back(fmt::format("within the error estimate of {}{}", reference,
                                same == cases ? "" : case_count_text(same, cases)));
  }
  if (close > 0)
    parts.push_back(largest_distance_text(row, AgreementWithReference::close, "at most ", cases));
  if (row.case_count_with_agreement(AgreementWithReference::distant) > 0) {
    parts.push_back(largest_distance_text(row, AgreementWithReference::distant, "up to ", cases));
  }
  if (const int no_reference = row.case_count_with_agreement(AgreementWithReference::no_reference);
      no_reference > 0) {
    parts.push_back("no reference" + case_count_text(no_reference, cases));
  }
  std::ranges::move(missing_density_texts(row, cases), std::back_inserter(parts));
  const bool all = row.reproduced_case_count() == row.case_count();
  const char* const start = all                               ? "reproduced: "
                            : row.reproduced_case_count() > 0 ? "reproduced in part: "
                                                              : "not reproduced: ";
  return fmt::format("{}{}", start, fmt::join(parts, "; "));
}

std::string outcome_text_without_distances(const SolutionAgreementOverCases& row, int cases) {
  const auto parts = missing_density_texts(row, cases);
  return parts.empty() ? "unknown" : parts.front();
}

char agreement_symbol(const SolutionAgreementInCase& entry) {
  if (entry.solution == nullptr) return kNone;
  const auto found =
      std::ranges::find(kStatusMarks, entry.solution->status, &std::pair<Status, char>::first);
  if (found != std::end(kStatusMarks)) return found->second;
  return entry.agreement == AgreementWithReference::indistinguishable ? kSame : kNone;
}

std::vector<std::string> agreement_symbol_meanings(
    const std::vector<SolutionAgreementOverCases>& agreement_rows) {
  const auto occurs = [&](char mark) {
    return std::ranges::any_of(agreement_rows, [&](const SolutionAgreementOverCases& row) {
      return std::ranges::any_of(row.entries, [&](const SolutionAgreementInCase& entry) {
        return agreement_symbol(entry) == mark;
      });
    });
  };
  std::vector<std::string> meanings;
  for (const auto& [status, mark] : kStatusMarks) {
    if (occurs(mark)) meanings.push_back(fmt::format("{} {}", mark, name(status)));
  }
  if (occurs(kSame)) {
    meanings.push_back(fmt::format(
        "{} indistinguishable: distance within the error estimate of the reference", kSame));
  }
  return meanings;
}

}  // namespace fpkcheck::report
