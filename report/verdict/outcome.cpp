#include "report/verdict/outcome.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

namespace fpkcheck::report {
namespace {

using transform::Status;

// Meaning of a status without a density.
std::string_view words_for(Status status) {
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

// "L1 distance up to .. in 2 of 4 cases", over the cases with this agreement.
std::string distance_text(const Record& record, Standing standing, const char* how, int cases) {
  MarginalDistances most{};
  for (const auto& stand : record.stands) {
    if (stand.standing == standing) most.widen(stand.y, stand.ydot);
  }
  const int count = record.count(standing);
  return fmt::format("L1 distance {}{}{}", cases == 1 ? "" : how, text_of(most),
                     count == cases ? "" : in_cases(count, cases));
}

std::vector<std::string> without_density(const Record& record, int cases) {
  std::vector<std::string> parts;
  for (const auto& [status, name, meaning] : transform::kStatusNames) {
    const auto count = std::ranges::count_if(record.stands, [status = status](const Stand& stand) {
      return stand.standing == Standing::no_density && stand.solution->status == status;
    });
    if (count == 0) continue;
    parts.push_back(
        fmt::format("{}{}: {}", name, in_cases(static_cast<int>(count), cases), words_for(status)));
  }
  return parts;
}

}  // namespace

void MarginalDistances::widen(const std::optional<double>& other_y,
                              const std::optional<double>& other_ydot) {
  const auto larger = [](std::optional<double>& mine, const std::optional<double>& other) {
    if (other) mine = std::max(mine.value_or(*other), *other);
  };
  larger(y, other_y);
  larger(ydot, other_ydot);
}

std::string text_of(const MarginalDistances& distances) {
  const auto& [y, ydot] = distances;
  if (!ydot) return fmt::format("{:.2g} in p(y)", y.value_or(0));
  if (!y) return fmt::format("{:.2g} in p(y')", *ydot);
  return fmt::format("{:.2g} in p(y) and {:.2g} in p(y')", *y, *ydot);
}

std::string in_cases(int count, int cases) {
  if (cases == 1) return "";
  if (count == cases) return fmt::format(" in {} {} cases", cases == 2 ? "both of" : "all", cases);
  return fmt::format(" in {} of {} cases", count, cases);
}

std::string outcome(const Record& record, const std::string& reference, int cases) {
  const int close = record.count(Standing::close);
  const int same = record.count(Standing::indistinguishable) + record.count(Standing::reference);
  std::vector<std::string> parts;
  if (same > 0) {
    parts.push_back(fmt::format("within the error estimate of {}{}", reference,
                                same == cases ? "" : in_cases(same, cases)));
  }
  if (close > 0) parts.push_back(distance_text(record, Standing::close, "at most ", cases));
  if (record.count(Standing::off) > 0) {
    parts.push_back(distance_text(record, Standing::off, "up to ", cases));
  }
  if (const int unjudged = record.count(Standing::unjudged); unjudged > 0) {
    parts.push_back("no reference" + in_cases(unjudged, cases));
  }
  std::ranges::move(without_density(record, cases), std::back_inserter(parts));
  const bool all = record.reproduced() == record.present();
  const char* const start = all                       ? "reproduced: "
                            : record.reproduced() > 0 ? "reproduced in part: "
                                                      : "not reproduced: ";
  return fmt::format("{}{}", start, fmt::join(parts, "; "));
}

std::string brief_outcome(const Record& record, int cases) {
  const auto parts = without_density(record, cases);
  return parts.empty() ? "unknown" : parts.front();
}

}  // namespace fpkcheck::report
