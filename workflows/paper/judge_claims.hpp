#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "workflows/paper/claims.hpp"

namespace fpkcheck::paper {

/// The outcome of the judgement of a claim.
enum class ClaimOutcome { established, qualified, not_established, unjudged };
/// The name of each outcome in files and tables, and the meaning of the outcome.
inline constexpr base::EnumEntry<ClaimOutcome> kOutcomeNames[] = {
    {ClaimOutcome::established, "established", "the run's numbers are as the claim states"},
    {ClaimOutcome::qualified, "established, but",
     "the numbers are as the claim states, but the solution is no probability density"},
    {ClaimOutcome::not_established, "not established", "the numbers are not as the claim states"},
    {ClaimOutcome::unjudged, "unjudged", "a number that decides the claim is missing"}};
constexpr const auto& enumerator_names(ClaimOutcome) { return kOutcomeNames; }
constexpr std::string_view name(ClaimOutcome outcome) { return base::name_of(outcome); }

/// A measured number and its limit.
struct MeasuredNumber {
  std::optional<double> value{};
  std::optional<double> limit{};
  bool above = false;  ///< true: the value must exceed the limit; false: must not exceed it

  bool satisfies_limit() const {
    return value && limit && (above ? *value > *limit : *value <= *limit);
  }
};

/// A claim of the paper, the measured numbers that decide about the claim, and the outcome.
struct Judgement {
  Claim claim;
  /// The largest L1 distance between closure and simulation over the cases and variables of the
  /// claim; for the relation is_linearisation, the L1 distance to the Gaussian of equivalent
  /// linearisation. An L1 distance without a limit is shown in tables, but does not influence the
  /// outcome of the claim.
  MeasuredNumber l1{};
  /// The tail distance compare::ErrorBudgetRow::total_tail: mean |log10 p - log10 MCS| over the
  /// bins with an MCS density of 1e-5 .. 1e-3. The tail distance is infinite if the closure is 0 in
  /// one of these bins.
  MeasuredNumber tail{};
  std::optional<transform::Status> status{};  ///< of the closure; the worst over the cases
  std::string reason{};                       ///< the closure's reason, where it is not `ok`
  ClaimOutcome outcome = ClaimOutcome::unjudged;
  std::string note{};  ///< explanation of the outcome, where one is needed
};

/// Judges all claims of the paper by the total distances of the error budget, which refer to the
/// simulation if the run has a simulation. Tables and figures use the same distances.
/// @param run run of the paper's cases by the methods kRequiredMethods; a claim has the outcome
///        `unjudged` if a required number is missing
std::vector<Judgement> judge_claims(const results::Run& run);

}  // namespace fpkcheck::paper
