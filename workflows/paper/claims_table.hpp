#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

/// The judgement of the claims as text for the terminal: a row for each claim with the measured
/// numbers and their limits, notes on the claims whose outcome is not `established`, the criteria
/// with their reasons, and a closing sentence.
std::string table(std::span<const Judgement> judgements, const report::TextFormat& format = {});

/// The cells of a claim's row in the table; absent values are empty.
struct ClaimRow {
  std::string cases, figure, claim, l1, l1_limit, tail, tail_limit, outcome;
};
std::vector<ClaimRow> claim_rows(std::span<const Judgement> judgements);

/// One line for each claim whose outcome is not `established`. The first line about a closure
/// quotes the reason of the closure's status.
std::vector<std::string> claim_notes(std::span<const Judgement> judgements);

/// Sentences that define the terms of the claims by numerical criteria
/// (workflows/paper/criteria.hpp).
std::vector<std::string> criteria_sentences();

/// The closing sentence, then a sentence for each outcome other than `established` with the claims
/// of this outcome.
std::vector<std::string> outcome_summary(std::span<const Judgement> judgements);

/// The sentence that counts the claims of each outcome: "44 claims of the paper: 36 established,
/// ..."
std::string closing_sentence(std::span<const Judgement> judgements);

/// The cases and the figures of the paper to which a claim refers. Cases: "1" or "1-4". Figures:
/// "2ab", "2-5", or "" if the claim refers to no figure.
std::string cases_text(const Claim& claim);
std::string figure_text(const Claim& claim);

}  // namespace fpkcheck::paper
