#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "workflows/paper/claims.hpp"

namespace fpkcheck::paper {

/// Outcome of the judgement of a claim.
enum class Outcome { established, qualified, not_established, unjudged };
/// Names in files and tables, and their meanings.
inline constexpr base::EnumEntry<Outcome> kOutcomeNames[] = {
    {Outcome::established, "established", "the run's numbers are as the claim states"},
    {Outcome::qualified, "established, but",
     "the numbers are as the claim states, but the solution is no probability density"},
    {Outcome::not_established, "not established", "the numbers are not as the claim states"},
    {Outcome::unjudged, "unjudged", "a number that decides the claim is missing"}};
constexpr std::span<const base::EnumEntry<Outcome>> names(Outcome) { return kOutcomeNames; }
constexpr std::string_view name(Outcome outcome) { return base::name_of(outcome); }

/// A measured number and its limit.
struct MeasuredNumber {
  std::optional<double> value{};
  std::optional<double> limit{};
  bool above = false;  ///< true: the value must exceed the limit; false: must not exceed it

  bool is_satisfied() const {
    return value && limit && (above ? *value > *limit : *value <= *limit);
  }
};

/// A claim, the numbers that decide it, and the outcome.
struct Judgement {
  Claim claim;
  /// L1 distance between closure and simulation (is_linearisation: to the Gaussian of equivalent
  /// linearisation); the largest over cases and variables. Without a limit it is shown but does not
  /// decide.
  MeasuredNumber l1{};
  /// Mean |log10 p - log10 MCS| where MCS is 1e-5 .. 1e-3: compare::BudgetRow::total_tail; infinite
  /// where the closure is 0 in part of that range.
  MeasuredNumber tail{};
  std::optional<transform::Status> status{};  ///< of the closure; the worst over the cases
  std::string reason{};                       ///< the closure's reason, where it is not `ok`
  Outcome outcome = Outcome::unjudged;
  std::string note{};  ///< explanation of the outcome, where one is needed
};

/// Judges all claims of the paper by the distances to the end of the error budget's chain of models
/// (the simulation, where the run has one). Tables and figures use the same distances.
/// @param run run of the paper's cases by the methods kRequiredMethods; claims without their
///        numbers are `unjudged`
std::vector<Judgement> judge(const results::Run& run);

}  // namespace fpkcheck::paper
