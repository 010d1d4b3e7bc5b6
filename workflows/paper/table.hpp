#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/text/format.hpp"
#include "workflows/paper/judge.hpp"

namespace fpkcheck::paper {

/// For people: a row a claim with its numbers and what they are held to, what must be said of those
/// that are not simply established, the criteria with their reasons, and a closing sentence.
std::string table(std::span<const Judgement> judgements, const report::TextFormat& format = {});

/// The cells of a claim's row; what is absent is empty.
struct Row {
  std::string cases, figure, claim, l1, l1_wanted, tail, tail_wanted, outcome;
};
std::vector<Row> rows(std::span<const Judgement> judgements);

/// What must be said of the claims that are not simply established, a line each: a closure's own
/// words are quoted where they come first.
std::vector<std::string> notes(std::span<const Judgement> judgements);

/// What the words of the claims mean in numbers (workflows/paper/criteria.hpp).
std::vector<std::string> criteria();

/// The closing sentence, and one for each outcome but `established` with its claims.
std::vector<std::string> summary(std::span<const Judgement> judgements);

/// "44 claims of the paper: 36 established, ..."
std::string closing_sentence(std::span<const Judgement> judgements);

/// Where the paper says it: "1" or "1-4", "2ab", "2-5" or "" for the text alone.
std::string cases_text(const Claim& claim);
std::string figure_text(const Claim& claim);

}  // namespace fpkcheck::paper
