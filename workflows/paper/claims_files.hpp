#pragma once

#include <span>
#include <string>

#include "results/run.hpp"
#include "workflows/paper/judge.hpp"

namespace fpkcheck::paper {

inline constexpr const char* kClaimsCsv = "claims.csv";
inline constexpr const char* kClaimsJson = "claims.json";

/// One row for each claim: case,figure,claim,n,density,relation,rival,l1,l1_wanted,tail,
/// tail_wanted,status,outcome,note,quote. Absent values are empty.
std::string claims_csv(std::span<const Judgement> judgements);

/// Contents of claims.json: program, criteria, and under `claims` the fields of the CSV with typed
/// numbers, and the closure's reason.
std::string claims_json(std::span<const Judgement> judgements, const results::Program& program);

/// The run's summary with the keys `criteria` and `claims`: the output of `--json`.
std::string summary_with_claims(std::span<const Judgement> judgements, const results::Run& run);

}  // namespace fpkcheck::paper
