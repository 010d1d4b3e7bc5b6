#include "report/verdict/outcome.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace fpkcheck::report {
namespace {

using transform::Status;

// The meaning of a status of solutions without a density.
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

// The largest distances over the cases with a given agreement: "L1 distance up to .. in 2 of 4
// cases".
std::string distance_text(const AgreementRow& row, Agreement agreement, const char* how,
                          int cases) {
  MarginalDistances most{};
  for (const auto& entry : row.entries) {
    if (entry.agreement == agreement) most.take_larger_distances(entry.y, entry.ydot);
  }
  const int count = row.case_count_with(agreement);
  return fmt::format("L1 distance {}{}{}", cases == 1 ? "" : how, distances_text(most),
                     count == cases ? "" : cases_phrase(count, cases));
}

std::vector<std::string> missing_density_texts(const AgreementRow& row, int cases) {
  std::vector<std::string> parts;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    const auto count =
        std::ranges::count_if(row.entries, [sought = status](const AgreementEntry& entry) {
          return entry.agreement == Agreement::no_density && entry.solution->status == sought;
        });
    if (count == 0) continue;
    parts.push_back(fmt::format("{}{}: {}", name, cases_phrase(static_cast<int>(count), cases),
                                status_meaning(status)));
  }
  return parts;
}

}  // namespace

void MarginalDistances::take_larger_distances(const std::optional<double>& other_y,
                                              const std::optional<double>& other_ydot) {
  const auto larger = [](std::optional<double>& mine, const std::optional<double>& other) {
    if (other) mine = std::max(mine.value_or(*other), *other);
  };
  larger(y, other_y);
  larger(ydot, other_ydot);
}

std::string distances_text(const MarginalDistances& distances) {
  const auto& [y, ydot] = distances;
  if (!ydot) return fmt::format("{:.2g} in p(y)", y.value_or(0));
  if (!y) return fmt::format("{:.2g} in p(y')", *ydot);
  return fmt::format("{:.2g} in p(y) and {:.2g} in p(y')", *y, *ydot);
}

std::string cases_phrase(int count, int cases) {
  if (cases == 1) return "";
  if (count == cases) return fmt::format(" in {} {} cases", cases == 2 ? "both of" : "all", cases);
  return fmt::format(" in {} of {} cases", count, cases);
}

std::string outcome_text(const AgreementRow& row, const std::string& reference, int cases) {
  const int close = row.case_count_with(Agreement::close);
  const int same =
      row.case_count_with(Agreement::indistinguishable) + row.case_count_with(Agreement::reference);
  std::vector<std::string> parts;
  if (same > 0) {
    parts.push_back(fmt::format("within the error estimate of {}{}", reference,
                                same == cases ? "" : cases_phrase(same, cases)));
  }
  if (close > 0) parts.push_back(distance_text(row, Agreement::close, "at most ", cases));
  if (row.case_count_with(Agreement::distant) > 0) {
    parts.push_back(distance_text(row, Agreement::distant, "up to ", cases));
  }
  if (const int no_reference = row.case_count_with(Agreement::no_reference); no_reference > 0) {
    parts.push_back("no reference" + cases_phrase(no_reference, cases));
  }
  std::ranges::move(missing_density_texts(row, cases), std::back_inserter(parts));
  const bool all = row.reproduced_case_count() == row.case_count();
  const char* const start = all                               ? "reproduced: "
                            : row.reproduced_case_count() > 0 ? "reproduced in part: "
                                                              : "not reproduced: ";
  return fmt::format("{}{}", start, fmt::join(parts, "; "));
}

std::string outcome_text_without_distances(const AgreementRow& row, int cases) {
  const auto parts = missing_density_texts(row, cases);
  return parts.empty() ? "unknown" : parts.front();
}

}  // namespace fpkcheck::report
