#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "workflows/paper/claims.hpp"

/// Texts of the L1 distances and tail ratios with which the claims of the paper are judged; the
/// text of an absent number is empty.

namespace fpkcheck::paper {

enum class PaperClaimOutcome { established, qualified, not_established, unjudged };
/// Name of each outcome of a claim in files and tables, and the meaning of the outcome.
inline constexpr base::EnumEntry<PaperClaimOutcome> kOutcomeNames[] = {
    {PaperClaimOutcome::established, "established", "the run's numbers are as the claim states"},
    {PaperClaimOutcome::qualified, "established, but",
     "the numbers are as the claim states, but the solution is no probability density"},
    {PaperClaimOutcome::not_established, "not established",
     "the numbers are not as the claim states"},
    {PaperClaimOutcome::unjudged, "unjudged", "a number that decides the claim is missing"}};
constexpr const auto& enumerator_names(PaperClaimOutcome) { return kOutcomeNames; }
constexpr std::string_view name(PaperClaimOutcome outcome) { return base::name_of(outcome); }

struct PaperClaimMeasurement {
  std::optional<double> value{};
  std::optional<double> limit{};
  /// Whether the claim requires a measured value above the limit, instead of a value of at most the
  /// limit.
  bool above = false;

  bool satisfies_limit() const {
    return value && limit && (above ? *value > *limit : *value <= *limit);
  }
};

/// Claim of the paper, the measured numbers that decide the claim, and the outcome of the
/// judgement.
struct PaperClaimJudgement {
  PaperClaim claim;
  /// Largest L1 distance between the closure and the simulation over the cases and variables of the
  /// claim. For the relation is_linearisation, `l1` is the L1 distance to the Gaussian of
  /// equivalent linearisation. An L1 distance without a limit is shown in tables, but does not
  /// influence the outcome of the claim.
  PaperClaimMeasurement l1{};
  /// Tail distance compare::ErrorBudgetRow::total_tail: mean |log10 p - log10 MCS| over the bins
  /// with an MCS density of 1e-5 .. 1e-3. The tail distance is infinite if the closure density is 0
  /// in a bin of the tail.
  PaperClaimMeasurement tail{};
  /// Status of the closure in the first case of the claim with a status other than `ok`, or `ok` if
  /// no such case exists.
  std::optional<transform::Status> status{};
  std::string reason{};  ///< reason for a status of the closure other than `ok`
  PaperClaimOutcome outcome = PaperClaimOutcome::unjudged;
  std::string note{};  ///< explanation of the outcome of the claim; may be empty
};

/// Judges all claims of the paper by the total distances of the error budget.
/// @param run run of the paper's cases by the methods kRequiredMethods. If a required number is
///        missing, the outcome of a claim is `unjudged`.
std::vector<PaperClaimJudgement> judge_claims(const results::Run& run);

std::string l1_distance_text(const std::optional<double>& l1);
std::string tail_distance_text(const std::optional<double>& tail);

}  // namespace fpkcheck::paper
