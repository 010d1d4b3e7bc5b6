#include "report/verdict/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace fpkcheck::report {
namespace {

using transform::Status;

constexpr std::pair<Status, char> kStatusMarks[] = {
    {Status::inaccurate, '~'}, {Status::inadmissible, '!'}, {Status::not_converged, 'x'},
    {Status::ill_posed, 'i'},  {Status::failed, 'f'},       {Status::not_offered, '-'},
};
constexpr char kSame = '=', kNone = ' ';

}  // namespace

char entry_mark(const AgreementEntry& entry) {
  if (entry.solution == nullptr) return kNone;
  const auto found =
      std::ranges::find(kStatusMarks, entry.solution->status, &std::pair<Status, char>::first);
  if (found != std::end(kStatusMarks)) return found->second;
  return entry.agreement == Agreement::indistinguishable ? kSame : kNone;
}

std::vector<std::string> mark_meanings(const std::vector<AgreementRow>& agreement_rows) {
  const auto occurs = [&](char mark) {
    return std::ranges::any_of(agreement_rows, [&](const AgreementRow& row) {
      return std::ranges::any_of(
          row.entries, [&](const AgreementEntry& entry) { return entry_mark(entry) == mark; });
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
