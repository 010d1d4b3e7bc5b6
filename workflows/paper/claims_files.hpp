#pragma once

#include <span>
#include <string>

#include "results/run.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

inline constexpr const char* kClaimsCsv = "claims.csv";
inline constexpr const char* kClaimsJson = "claims.json";

/// The claims in CSV with a row for each claim:
/// case,figure,claim,n,density,relation,rival,l1,l1_wanted,tail,
/// tail_wanted,status,outcome,note,quote. Absent values are empty.
std::string claims_csv(std::span<const Judgement> judgements);

/// The contents of claims.json: the program, the criteria, and the list `claims`. An element of
/// this list has the fields of the CSV, with numbers as JSON numbers, and the reason of the
/// closure's status.
std::string claims_json(std::span<const Judgement> judgements, const results::Program& program);

/// The summary of the run in JSON with the additional keys `criteria` and `claims`: the output of
/// `--json`.
std::string summary_with_claims(std::span<const Judgement> judgements, const results::Run& run);

}  // namespace fpkcheck::paper
