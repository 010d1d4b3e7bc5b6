#pragma once

#include <span>
#include <string>

#include "results/run.hpp"
#include "workflows/paper/judge_claims.hpp"

namespace fpkcheck::paper {

inline constexpr const char* kClaimsCsv = "claims.csv";
inline constexpr const char* kClaimsJson = "claims.json";

/// Returns the judged claims as CSV with a row for each claim. Missing values are empty fields.
std::string claims_csv(std::span<const ClaimJudgement> judgements);

/// Returns the contents of claims.json: the program, the criteria, and the list `claims`. Each
/// element of `claims` has the fields of claims.csv and the reason for the status of the closure.
std::string claims_json(std::span<const ClaimJudgement> judgements,
                        const results::ProgramInfo& program);

/// Returns the output of --json, the summary of the run with the additional keys `criteria` and
/// `claims`.
std::string summary_json_with_claims(std::span<const ClaimJudgement> judgements,
                                     const results::Run& run);

}  // namespace fpkcheck::paper
