#pragma once

#include <span>
#include <string>

#include "results/run.hpp"
#include "workflows/paper/judge.hpp"

namespace fpkcheck::paper {

inline constexpr const char* kClaimsCsv = "claims.csv";
inline constexpr const char* kClaimsJson = "claims.json";

/// A row a claim: case,figure,claim,n,density,relation,rival,l1,l1_wanted,tail,tail_wanted,status,
/// outcome,note,quote. What is absent is empty.
std::string claims_csv(std::span<const Judgement> judgements);

/// The contents of claims.json: program, criteria, and under `claims` the same with numbers as
/// numbers and the closure's reason.
std::string claims_json(std::span<const Judgement> judgements, const results::Program& program);

/// The run's summary with `criteria` and `claims` in it: what `--json` prints.
std::string summary_with_claims(std::span<const Judgement> judgements, const results::Run& run);

}  // namespace fpkcheck::paper
