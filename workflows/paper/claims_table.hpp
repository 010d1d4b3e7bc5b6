#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "workflows/paper/judge.hpp"

namespace fpkcheck::paper {

/// Text for the terminal: a row for each claim with its numbers and limits, notes on the claims
/// that are not simply established, the criteria with their reasons, and a closing sentence.
std::string table(std::span<const Judgement> judgements, const report::TextFormat& format = {});

/// Cells of a claim's row; absent values are empty.
struct Row {
  std::string cases, figure, claim, l1, l1_limit, tail, tail_limit, outcome;
};
std::vector<Row> rows(std::span<const Judgement> judgements);

/// One line for each claim that is not simply established. The reason of a closure is quoted in the
/// first of its lines.
std::vector<std::string> notes(std::span<const Judgement> judgements);

/// The numerical meaning of the claims' terms (workflows/paper/criteria.hpp).
std::vector<std::string> criteria();

/// The closing sentence, then a sentence for each outcome other than `established`, with its
/// claims.
std::vector<std::string> summary(std::span<const Judgement> judgements);

/// "44 claims of the paper: 36 established, ..."
std::string closing_sentence(std::span<const Judgement> judgements);

/// Place of the claim in the paper: cases "1" or "1-4"; figures "2ab", "2-5", or "" for the text
/// alone.
std::string cases_text(const Claim& claim);
std::string figure_text(const Claim& claim);

}  // namespace fpkcheck::paper
