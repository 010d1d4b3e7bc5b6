#include "workflows/sweep/report/page/reasons.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <tuple>

namespace fpkcheck::sweep {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The index after the last character of the number that begins at a given index.
std::size_t end_of_number(const std::string& text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
    ++at;
    while (at < text.size() && is_digit(text[at])) ++at;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const bool has_sign = at + 1 < text.size() && (text[at + 1] == '-' || text[at + 1] == '+');
    const std::size_t digits = at + (has_sign ? 2 : 1);
    if (digits < text.size() && is_digit(text[digits])) {
      at = digits;
      while (at < text.size() && is_digit(text[at])) ++at;
    }
  }
  return at;
}

}  // namespace

std::string replace_numbers(const std::string& reason) {
  std::string text;
  for (std::size_t at = 0; at < reason.size();) {
    const bool in_word = at > 0 && (is_letter(reason[at - 1]) || is_digit(reason[at - 1]));
    const bool is_signed = reason[at] == '-' && at + 1 < reason.size() && is_digit(reason[at + 1]);
    if (in_word || !(is_digit(reason[at]) || is_signed)) {
      text += reason[at++];
      continue;
    }
    text += "...";
    at = end_of_number(reason, at + (is_signed ? 1 : 0));
  }
  return text;
}

std::vector<ReasonGroup> reason_groups(const SweepResults& results) {
  std::map<std::tuple<std::size_t, transform::Status, std::string>, ReasonGroup> found;
  for (const auto& point : results.points) {
    for (std::size_t m = 0; m < point.methods.size(); ++m) {
      const auto& [status, reason] = std::tie(point.methods[m].status, point.methods[m].reason);
      if (status == transform::Status::ok) continue;
      auto& group = found[{m, status, replace_numbers(reason)}];
      if (group.count++ == 0) {
        group = {.method = m, .status = status, .count = 1, .point = point.point, .reason = reason};
      }
    }
  }
  std::vector<ReasonGroup> groups;
  for (auto& [key, group] : found) groups.push_back(std::move(group));
  std::ranges::stable_sort(groups, std::ranges::greater(), &ReasonGroup::count);
  return groups;
}

}  // namespace fpkcheck::sweep
