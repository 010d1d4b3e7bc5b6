#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/text/text_layout.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

/// Returns the terminal text on the claims of the paper: a row for each claim, notes on claims that
/// are not `established`, the criteria, and a closing sentence.
std::string claims_table_text(std::span<const PaperClaimJudgement> judgements,
                              const report::TerminalTextFormat& format = {});

/// Texts of the table cells of a claim of the paper; missing values are empty texts.
struct PaperClaimTableRow {
  std::string cases, figure, claim, l1, l1_limit, tail, tail_limit, outcome;
};
std::vector<PaperClaimTableRow> claim_table_rows(std::span<const PaperClaimJudgement> judgements);

/// Returns one line of text for each claim of the paper whose outcome is not `established`. The
/// first line about a closure quotes the reason for a status of the closure other than `ok`.
std::vector<std::string> claim_notes(std::span<const PaperClaimJudgement> judgements);

/// Returns sentences that define the terms of the paper's claims by the limits in
/// workflows/paper/claim_criteria.hpp.
std::vector<std::string> claim_criteria_sentences();

/// Returns the closing sentence on the claims of the paper, and for each outcome other than
/// `established` a sentence that lists the claims with this outcome.
std::vector<std::string> claim_outcome_summary(std::span<const PaperClaimJudgement> judgements);

/// Returns a sentence with the number of claims for each outcome: "44 claims of the paper: 36
/// established, ..".
std::string claim_count_sentence(std::span<const PaperClaimJudgement> judgements);

/// Texts of the cases and of the figures of a claim, e.g. cases "1" or "1-4", and figures "2ab" or
/// "2-5". If no figure of the paper shows a claim, the text of the claim's figures is empty.
std::string claim_cases_text(const PaperClaim& claim);
std::string claim_figure_text(const PaperClaim& claim);

}  // namespace fpkcheck::paper
