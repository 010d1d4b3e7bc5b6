#include "workflows/paper/claims_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

#include "report/text/number_text.hpp"
#include "report/text/text_layout.hpp"
#include "workflows/paper/claim_criteria.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {
namespace {

using report::kAlwaysShown;
using report::TextTableColumn;

std::string limit_text(const PaperClaimMeasurement& of, const std::string& limit) {
  return limit.empty() ? "" : fmt::format("{} {}", of.above ? ">" : "<=", limit);
}

// The relation `differs` between a closure and the simulation holds if the L1 distance or the tail
// distance exceeds its limit.
std::string tail_limit_text(const PaperClaimJudgement& judgement) {
  const std::string text = limit_text(judgement.tail, tail_distance_text(judgement.tail.limit));
  return judgement.claim.relation == PaperClaimRelation::differs && !text.empty() ? "or " + text
                                                                                  : text;
}

std::string cell_or_dash(const std::string& cell) {
  return cell.empty() ? std::string(report::kMissingCell) : cell;
}

std::string claim_rows_text(std::span<const PaperClaimJudgement> judgements,
                            const report::TerminalTextFormat& format) {
  constexpr int kLimits = 1;
  std::vector<TextTableColumn> columns{{"", "case", true, kAlwaysShown},
                                       {"", "fig.", true, kAlwaysShown},
                                       {"", "claim of the paper", true, kAlwaysShown},
                                       {"L1", "is", false, kAlwaysShown},
                                       {"L1", "required", true, kLimits},
                                       {"tail", "is", false, kAlwaysShown},
                                       {"tail", "required", true, kLimits},
                                       {"", "outcome", true, kAlwaysShown}};
  for (const auto& row : claim_table_rows(judgements)) {
    report::add_table_row(columns,
                          {row.cases, cell_or_dash(row.figure), row.claim, cell_or_dash(row.l1),
                           row.l1_limit, cell_or_dash(row.tail), row.tail_limit, row.outcome});
  }
  return report::format_text_table(std::move(columns), format);
}

// Returns the claims of the paper with a given outcome. Each claim is listed once, with the cases
// that have the given outcome, e.g. "n=6 agrees with MCS in p(y) (case 1, 2)".
std::string claims_with_outcome(std::span<const PaperClaimJudgement> judgements,
                                PaperClaimOutcome outcome) {
  std::vector<std::pair<std::string, std::string>> claims;
  for (const auto& judgement : judgements) {
    if (judgement.outcome != outcome) continue;
    const std::string claim = claim_text(judgement.claim);
    const auto known =
        std::ranges::find(claims, claim, &std::pair<std::string, std::string>::first);
    if (known == claims.end()) {
      claims.emplace_back(claim, claim_cases_text(judgement.claim));
    } else {
      known->second += ", " + claim_cases_text(judgement.claim);
    }
  }
  std::vector<std::string> texts;
  for (const auto& [claim, cases] : claims)
    texts.push_back(fmt::format("{} (case {})", claim, cases));
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::vector<PaperClaimTableRow> claim_table_rows(std::span<const PaperClaimJudgement> judgements) {
  std::vector<PaperClaimTableRow> all;
  for (const auto& judgement : judgements) {
    all.push_back({.cases = claim_cases_text(judgement.claim),
                   .figure = claim_figure_text(judgement.claim),
                   .claim = claim_text(judgement.claim),
                   .l1 = judgement.l1.value ? report::l1_distance_text(*judgement.l1.value) : "",
                   .l1_limit = limit_text(judgement.l1, l1_distance_text(judgement.l1.limit)),
                   .tail = judgement.tail.value ? fmt::format("{:.3f}", *judgement.tail.value) : "",
                   .tail_limit = tail_limit_text(judgement),
                   .outcome = std::string(name(judgement.outcome))});
  }
  return all;
}

std::vector<std::string> claim_notes(std::span<const PaperClaimJudgement> judgements) {
  std::set<std::pair<int, int>> quoted_closures;  // case and order n of a closure
  std::vector<std::string> lines;
  for (const auto& judgement : judgements) {
    const bool is_search = judgement.claim.relation == PaperClaimRelation::not_found;
    if (judgement.note.empty() && !is_search) continue;
    std::string line = fmt::format("case {}, {}: {}", claim_cases_text(judgement.claim),
                                   claim_text(judgement.claim), name(judgement.outcome));
    if (!judgement.note.empty()) {
      line += fmt::format("{} {}", judgement.outcome == PaperClaimOutcome::qualified ? "" : ":",
                          judgement.note);
    }
    const bool shows_reason = is_search || judgement.status == transform::Status::inadmissible;
    if (shows_reason && !judgement.reason.empty() &&
        quoted_closures.insert({judgement.claim.cases.front(), judgement.claim.order}).second) {
      line += ": " + judgement.reason;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<std::string> claim_criteria_sentences() {
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
                  kMaxL1OfClaimedAgreement, kMaxTailDistanceOfClaimedAgreement),
      fmt::format("equivalent linearisation: L1 to its Gaussian at most {:g}. not found: plain "
                  "Newton steps from equivalent linearisation find no root.",
                  kMaxL1BetweenEqualGaussians)};
}

std::string claim_cases_text(const PaperClaim& claim) {
  const auto& cases = claim.cases;
  return cases.size() == 1 ? fmt::format("{}", cases.front())
                           : fmt::format("{}-{}", cases.front(), cases.back());
}

std::string claim_figure_text(const PaperClaim& claim) {
  if (claim.panels.empty()) return "";
  const int first = PaperClaim::figure_number(claim.cases.front()),
            last = PaperClaim::figure_number(claim.cases.back());
  return first == last ? fmt::format("{}{}", first, claim.panels)
                       : fmt::format("{}-{}", first, last);
}

std::string claim_count_sentence(std::span<const PaperClaimJudgement> judgements) {
  std::vector<std::string> parts;
  for (const auto& [outcome, name, meaning] : kOutcomeNames) {
    const auto count = std::ranges::count(judgements, outcome, &PaperClaimJudgement::outcome);
    if (count == 0) continue;
    parts.push_back(meaning.empty() ? fmt::format("{} {}", count, name)
                                    : fmt::format("{} {} ({})", count, name, meaning));
  }
  return fmt::format("{} claims of the paper: {}.", judgements.size(), fmt::join(parts, "; "));
}

std::vector<std::string> claim_outcome_summary(std::span<const PaperClaimJudgement> judgements) {
  std::vector<std::string> sentences{claim_count_sentence(judgements)};
  for (const auto outcome : {PaperClaimOutcome::qualified, PaperClaimOutcome::not_established,
                             PaperClaimOutcome::unjudged}) {
    const std::string claims = claims_with_outcome(judgements, outcome);
    if (claims.empty()) continue;
    std::string subject(name(outcome));
    subject.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(subject.front())));
    sentences.push_back(fmt::format("{}: {}.", subject, claims));
  }
  return sentences;
}

std::string claims_table_text(std::span<const PaperClaimJudgement> judgements,
                              const report::TerminalTextFormat& format) {
  std::string text = claim_rows_text(judgements, format);
  for (const auto& line : claim_notes(judgements)) {
    text += report::wrap_text("  " + line, format.width, 4);
  }
  text += '\n';
  for (const auto& sentence : claim_criteria_sentences()) {
    text += report::wrap_text(sentence, format.width);
  }
  return text + '\n' + report::wrap_text(claim_count_sentence(judgements), format.width);
}

}  // namespace fpkcheck::paper
