#include "workflows/paper/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

#include "report/text/columns.hpp"
#include "report/text/l1_text.hpp"
#include "report/text/wrapped.hpp"
#include "workflows/paper/criteria.hpp"
#include "workflows/paper/measured_text.hpp"

namespace fpkcheck::paper {
namespace {

using report::Column;
using report::kAlwaysShown;

std::string wanted(const Measured& of, const std::string& limit) {
  return limit.empty() ? "" : fmt::format("{} {}", of.above ? ">" : "<=", limit);
}

// `differs` holds if L1 or the tail exceeds its limit.
std::string tail_wanted(const Judgement& one) {
  const std::string text = wanted(one.tail, tail_text(one.tail.limit));
  return one.claim.relation == Relation::differs && !text.empty() ? "or " + text : text;
}

std::string absent(const std::string& cell) {
  return cell.empty() ? std::string(report::kAbsent) : cell;
}

std::string table_rows(std::span<const Judgement> judgements, const report::TextFormat& format) {
  constexpr int kLimits = 1;
  std::vector<Column> columns{{"", "case", true, kAlwaysShown},
                              {"", "fig.", true, kAlwaysShown},
                              {"", "claim of the paper", true, kAlwaysShown},
                              {"L1", "is", false, kAlwaysShown},
                              {"L1", "required", true, kLimits},
                              {"tail", "is", false, kAlwaysShown},
                              {"tail", "required", true, kLimits},
                              {"", "outcome", true, kAlwaysShown}};
  for (const auto& row : rows(judgements)) {
    const std::string cells[] = {row.cases,     absent(row.figure), row.claim,       absent(row.l1),
                                 row.l1_wanted, absent(row.tail),   row.tail_wanted, row.outcome};
    for (std::size_t k = 0; k < columns.size(); ++k) columns[k].cells.push_back(cells[k]);
  }
  return report::rows(std::move(columns), format);
}

// "n=6 agrees with MCS in p(y) (case 1, 2)": each claim once, with the cases of this outcome.
std::string claims_with(std::span<const Judgement> judgements, Outcome outcome) {
  std::vector<std::pair<std::string, std::string>> claims;
  for (const auto& one : judgements) {
    if (one.outcome != outcome) continue;
    const std::string claim = words(one.claim);
    const auto known =
        std::ranges::find(claims, claim, &std::pair<std::string, std::string>::first);
    if (known == claims.end()) {
      claims.emplace_back(claim, cases_text(one.claim));
    } else {
      known->second += ", " + cases_text(one.claim);
    }
  }
  std::vector<std::string> texts;
  for (const auto& [claim, cases] : claims)
    texts.push_back(fmt::format("{} (case {})", claim, cases));
  return fmt::format("{}", fmt::join(texts, "; "));
}

std::string indented(const std::vector<std::string>& lines, std::size_t width) {
  std::string text;
  for (const auto& line : lines) text += report::wrapped("  " + line, width, 4);
  return text;
}

std::string paragraphs(const std::vector<std::string>& sentences, std::size_t width) {
  std::string text;
  for (const auto& sentence : sentences) text += report::wrapped(sentence, width);
  return text;
}

}  // namespace

std::vector<Row> rows(std::span<const Judgement> judgements) {
  std::vector<Row> all;
  for (const auto& one : judgements) {
    all.push_back({.cases = cases_text(one.claim),
                   .figure = figure_text(one.claim),
                   .claim = words(one.claim),
                   .l1 = one.l1.value ? report::l1_text(*one.l1.value) : "",
                   .l1_wanted = wanted(one.l1, l1_text(one.l1.limit)),
                   .tail = one.tail.value ? fmt::format("{:.3f}", *one.tail.value) : "",
                   .tail_wanted = tail_wanted(one),
                   .outcome = std::string(name(one.outcome))});
  }
  return all;
}

std::vector<std::string> notes(std::span<const Judgement> judgements) {
  std::set<std::pair<int, int>> quoted;  // case, n
  std::vector<std::string> lines;
  for (const auto& one : judgements) {
    const bool of_a_search = one.claim.relation == Relation::not_found;
    if (one.note.empty() && !of_a_search) continue;
    std::string line =
        fmt::format("case {}, {}: {}", cases_text(one.claim), words(one.claim), name(one.outcome));
    if (!one.note.empty()) {
      line += fmt::format("{} {}", one.outcome == Outcome::qualified ? "" : ":", one.note);
    }
    const bool speaks = of_a_search || one.status == transform::Status::inadmissible;
    if (speaks && !one.reason.empty() &&
        quoted.insert({one.claim.cases.front(), one.claim.order}).second) {
      line += ": " + one.reason;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> criteria() {
  return {
      fmt::format("MCS: the simulation; n: the order of the paper's closure, epc-gaussian. L1: "
                  "integral of |p - MCS|. tail: mean |log10 p - log10 MCS| where MCS is 1e-5 .. "
                  "1e-3."),
      fmt::format("agrees: L1 at most {:g}, the accuracy required of closures, and tail at most "
                  "{:g}, a factor of 1.6: the resolution of a simulation with the paper's 1e7 "
                  "samples. differs: L1 or tail exceeds its limit. better: both are smaller, by "
                  "more than the error of the reference (L1: its error estimate; tail: its "
                  "distance to finite volumes). less Gaussian: the L1 of n=2, a Gaussian, is "
                  "larger than in case 1.",
                  kAgreementL1, kAgreementInTail),
      fmt::format("equivalent linearisation: L1 to its Gaussian at most {:g}. not found: plain "
                  "Newton steps from equivalent linearisation find no root.",
                  kSameGaussianL1)};
}

std::string cases_text(const Claim& claim) {
  const auto& cases = claim.cases;
  return cases.size() == 1 ? fmt::format("{}", cases.front())
                           : fmt::format("{}-{}", cases.front(), cases.back());
}

std::string figure_text(const Claim& claim) {
  if (claim.panels.empty()) return "";
  const int first = Claim::figure(claim.cases.front()), last = Claim::figure(claim.cases.back());
  return first == last ? fmt::format("{}{}", first, claim.panels)
                       : fmt::format("{}-{}", first, last);
}

std::string closing_sentence(std::span<const Judgement> judgements) {
  std::vector<std::string> parts;
  for (const auto& [outcome, name, meaning] : kOutcomeNames) {
    const auto count = std::ranges::count(judgements, outcome, &Judgement::outcome);
    if (count == 0) continue;
    parts.push_back(meaning.empty() ? fmt::format("{} {}", count, name)
                                    : fmt::format("{} {} ({})", count, name, meaning));
  }
  return fmt::format("{} claims of the paper: {}.", judgements.size(), fmt::join(parts, "; "));
}

std::vector<std::string> summary(std::span<const Judgement> judgements) {
  std::vector<std::string> sentences{closing_sentence(judgements)};
  for (const auto outcome : {Outcome::qualified, Outcome::not_established, Outcome::unjudged}) {
    const std::string claims = claims_with(judgements, outcome);
    if (claims.empty()) continue;
    std::string subject(name(outcome));
    subject.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(subject.front())));
    sentences.push_back(fmt::format("{}: {}.", subject, claims));
  }
  return sentences;
}

std::string table(std::span<const Judgement> judgements, const report::TextFormat& format) {
  return table_rows(judgements, format) + indented(notes(judgements), format.width) + '\n' +
         paragraphs(criteria(), format.width) + '\n' +
         report::wrapped(closing_sentence(judgements), format.width);
}

}  // namespace fpkcheck::paper
