#pragma once

#include <optional>
#include <string>
#include <vector>

#include "results/run.hpp"
#include "workflows/paper/claims.hpp"

namespace fpkcheck::paper {

/// What a run says of a claim.
enum class Outcome { established, qualified, not_established, unjudged };
/// As written in files and tables.
inline constexpr base::Named<Outcome> kOutcomeNames[] = {
    {Outcome::established, "established", "the run's numbers are as the claim states"},
    {Outcome::qualified, "established, but",
     "the numbers are as the claim states, of a solution that is no probability density"},
    {Outcome::not_established, "not established", "the numbers are not as the claim states"},
    {Outcome::unjudged, "unjudged", "a number that decides it is missing"}};
constexpr std::span<const base::Named<Outcome>> names(Outcome) { return kOutcomeNames; }
constexpr std::string_view name(Outcome outcome) { return base::name_of(outcome); }

/// A number and what it is held to.
struct Measured {
  std::optional<double> value{};
  std::optional<double> limit{};
  bool above = false;  ///< whether it complies above the limit, or at and below it

  bool complies() const { return value && limit && (above ? *value > *limit : *value <= *limit); }
};

/// A claim with the numbers that decide it.
struct Judgement {
  Claim claim;
  /// L1 of the closure to the simulation (is_linearisation: to that Gaussian); of several cases or
  /// variables the largest. Without a limit it does not decide.
  Measured l1{};
  /// Mean |log10 p - log10 MCS| where MCS is 1e-5 .. 1e-3: compare::BudgetRow::total_tail; infinite
  /// where the closure is 0 in part of that.
  Measured tail{};
  std::optional<transform::Status> status{};  ///< of the closure; of several the worst
  std::string reason{};                       ///< the closure's own words, where it is not `ok`
  Outcome outcome = Outcome::unjudged;
  std::string note{};  ///< what must be said beside the outcome, if anything
};

/// All claims of the paper, judged by what a run found: by distances to the end of the error
/// budget's chain (the simulation, where it is there), as tables and pictures have them.
/// @param run of the paper's cases, by the methods kMethods; what is missing leaves claims unjudged
std::vector<Judgement> judge(const results::Run& run);

}  // namespace fpkcheck::paper
