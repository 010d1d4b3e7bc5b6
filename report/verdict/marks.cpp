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

char mark_of(const Stand& stand) {
  if (stand.solution == nullptr) return kNone;
  const auto found =
      std::ranges::find(kStatusMarks, stand.solution->status, &std::pair<Status, char>::first);
  if (found != std::end(kStatusMarks)) return found->second;
  return stand.standing == Standing::indistinguishable ? kSame : kNone;
}

std::vector<std::string> meanings_of_marks(const std::vector<Record>& records) {
  const auto stands_somewhere = [&](char mark) {
    return std::ranges::any_of(records, [&](const Record& record) {
      return std::ranges::any_of(record.stands,
                                 [&](const Stand& stand) { return mark_of(stand) == mark; });
    });
  };
  std::vector<std::string> meanings;
  for (const auto& [status, mark] : kStatusMarks) {
    if (stands_somewhere(mark)) meanings.push_back(fmt::format("{} {}", mark, name(status)));
  }
  if (stands_somewhere(kSame)) {
    meanings.push_back(fmt::format(
        "{} indistinguishable: distance within the error estimate of the reference", kSame));
  }
  return meanings;
}

}  // namespace fpkcheck::report
