#pragma once

#include <span>
#include <string>

#include "paper/judge.hpp"
#include "report/text/format.hpp"

namespace fpkcheck::paper {

/// For people: a row a claim with its numbers and what they are held to, what must be said of those
/// that are not simply established, the criteria with their reasons, and a closing sentence.
std::string table(std::span<const Judgement> judgements, const report::TextFormat& format = {});

/// "44 claims of the paper: 36 established, ..."
std::string closing_sentence(std::span<const Judgement> judgements);

/// Where the paper says it: "1" or "1-4", "2ab", "2-5" or "" for the text alone.
std::string cases_text(const Claim& claim);
std::string figure_text(const Claim& claim);

}  // namespace fpkcheck::paper
