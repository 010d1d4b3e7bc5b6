#include "workflows/paper/judge_claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "report/text/number_text.hpp"
#include "workflows/paper/claim_criteria.hpp"
#include "workflows/paper/closure_distances.hpp"

namespace fpkcheck::paper {
namespace {

using results::CaseResult;
using transform::Solution;
using transform::Status;

class PaperClaimJudge {
 public:
  PaperClaimJudge(const results::Run& run, const PaperClaim& claim)
      : run_(run), judgement_{.claim = claim} {}

  PaperClaimJudgement make_judgement() {
    store_closure_status();
    const std::optional<bool> holds = missing_reason_.empty() ? evaluate_claim() : std::nullopt;
    if (!holds) {
      judgement_.outcome = PaperClaimOutcome::unjudged;
      judgement_.note = missing_reason_;
    } else if (claim().relation == PaperClaimRelation::not_found) {
      judge_root_search(*holds);
    } else {
      judge_distances(*holds);
    }
    return judgement_;
  }

 private:
  const PaperClaim& claim() const { return judgement_.claim; }

  const CaseResult* find_case(int number) {
    const auto found = std::ranges::find(run_.cases, paper_case_name(number), &CaseResult::name);
    if (found != run_.cases.end()) return &*found;
    missing_reason_ = fmt::format("the run has no {}", paper_case_name(number));
    return nullptr;
  }

  // Stores the status of the closure in the first case of the claim in which this status is not
  // `ok`.
  void store_closure_status() {
    for (const int number : claim().cases) {
      const CaseResult* case_result = find_case(number);
      if (case_result == nullptr) return;
      const Solution* closure = case_result->find(paper_closure_id(claim().order));
      if (closure == nullptr || closure->status == Status::failed) {
        missing_reason_ =
            closure == nullptr
                ? fmt::format("{} has no {}", case_result->name(), paper_closure_id(claim().order))
                : fmt::format("{} failed in {}", closure->id(), case_result->name());
        return;
      }
      if (judgement_.status && *judgement_.status != Status::ok) continue;
      judgement_.status = closure->status;
      judgement_.reason = closure->reason;
    }
  }

  // Returns the maxima of the L1 distance and the tail distance over the given cases and over the
  // variables of the claim.
  std::optional<ClosureDistanceFromSimulation> largest_distance(int order,
                                                                const std::vector<int>& cases) {
    ClosureDistanceFromSimulation worst;
    for (const int number : cases) {
      const CaseResult* case_result = find_case(number);
      if (case_result == nullptr) return std::nullopt;
      for (const auto variable : claim().variables) {
        const auto next =
            closure_distance_to_simulation(*case_result, order, variable, missing_reason_);
        if (!next) return std::nullopt;
        worst = componentwise_maximum(worst, *next);
      }
    }
    return worst;
  }

  // Returns whether the tail distance of a closure exists, and otherwise sets the reason for the
  // missing value.
  bool require_tail_distance(const ClosureDistanceFromSimulation& distance) {
    if (!std::isnan(distance.tail)) return true;
    missing_reason_ = "no bin of the tail is positive and resolved in all solutions";
    return false;
  }

  // Returns whether a claim of the paper holds; empty if a required number is missing.
  std::optional<bool> evaluate_claim() {
    using enum PaperClaimRelation;
    const PaperClaimRelation relation = claim().relation;
    if (relation == not_found) return !plain_newton_converges();
    if (relation == is_linearisation) return equals_linearised_gaussian();

    const auto closure_distance = largest_distance(claim().order, claim().cases);
    if (!closure_distance) return std::nullopt;
    auto& l1 = judgement_.l1;
    auto& tail = judgement_.tail;
    l1.value = closure_distance->l1;
    if (!std::isnan(closure_distance->tail)) tail.value = closure_distance->tail;

    if (relation == further_than_in_case_1) {
      const auto first = largest_distance(claim().order, {1});
      if (!first) return std::nullopt;
      l1 = {closure_distance->l1, first->l1 + closure_distance->l1_error + first->l1_error, true};
      return l1.satisfies_limit();
    }
    const bool uses_l1 =
        relation != agrees_in_tail && relation != differs_in_tail && relation != closer_in_tail;
    const bool uses_tail = relation != closer_in_l1;
    if (uses_tail && !require_tail_distance(*closure_distance)) return std::nullopt;
    const bool differ = relation == differs || relation == differs_in_tail;
    ClosureDistanceFromSimulation limit{.l1 = kMaxL1OfClaimedAgreement,
                                        .tail = kMaxTailDistanceOfClaimedAgreement};
    if (claim().rival != 0) {
      const auto rival = largest_distance(claim().rival, claim().cases);
      if (!rival || (uses_tail && !require_tail_distance(*rival))) return std::nullopt;
      // To differ, the distances of two compared closures must differ by more than the error
      // estimate of the reference.
      limit = {.l1 = rival->l1 - closure_distance->l1_error,
               .tail = rival->tail - closure_distance->tail_error};
    }
    if (uses_l1) l1 = {closure_distance->l1, limit.l1, differ};
    if (uses_tail) tail = {closure_distance->tail, limit.tail, differ};
    if (differ) return l1.satisfies_limit() || tail.satisfies_limit();
    return (!uses_l1 || l1.satisfies_limit()) && (!uses_tail || tail.satisfies_limit());
  }

  std::optional<bool> equals_linearised_gaussian() {
    double largest = 0;
    for (const int number : claim().cases) {
      const CaseResult* case_result = find_case(number);
      if (case_result == nullptr) return std::nullopt;
      for (const auto variable : claim().variables) {
        const auto* curve = case_result->marginal_curve(paper_closure_id(claim().order), variable);
        if (curve == nullptr) {
          missing_reason_ = fmt::format("{} has no density of {}", case_result->name(),
                                        paper_closure_id(claim().order));
          return std::nullopt;
        }
        largest = std::max(largest, l1_to_equivalent_linearisation(*curve, case_result->problem));
      }
    }
    judgement_.l1 = {largest, kMaxL1BetweenEqualGaussians};
    return judgement_.l1.satisfies_limit();
  }

  // Runs of older program versions lack the metric "plain_newton_converges", and are assumed to
  // have converged.
  bool plain_newton_converges() {
    const Solution* closure =
        find_case(claim().cases.front())->find(paper_closure_id(claim().order));
    if (closure->status == Status::not_converged) return false;
    const auto* observed = transform::find_metric(closure->metrics, "plain_newton_converges");
    const auto* converges = observed == nullptr ? nullptr : std::get_if<bool>(&observed->value);
    return converges == nullptr || *converges;
  }

  void judge_root_search(bool holds) {
    judgement_.outcome =
        holds ? PaperClaimOutcome::established : PaperClaimOutcome::not_established;
    if (judgement_.status == Status::not_converged) return;
    judgement_.note = fmt::format("{} a root{}",
                                  holds ? "plain Newton steps find no root, but other methods find"
                                        : "plain Newton steps from equivalent linearisation find",
                                  is_inadmissible() ? fmt::format(", which {}", kNoDensity) : "");
  }

  void judge_distances(bool holds) {
    judgement_.outcome =
        holds ? PaperClaimOutcome::established : PaperClaimOutcome::not_established;
    const bool claims_accuracy = claim().relation != PaperClaimRelation::differs &&
                                 claim().relation != PaperClaimRelation::differs_in_tail;
    if (!holds) judgement_.note = unmet_limits_text();
    if (!claims_accuracy || !is_inadmissible()) return;
    if (holds) judgement_.outcome = PaperClaimOutcome::qualified;
    judgement_.note += fmt::format("{}n={} {}", holds ? "" : "; and ", claim().order, kNoDensity);
  }

  bool is_inadmissible() const { return judgement_.status == Status::inadmissible; }

  std::string unmet_limits_text() const {
    std::string text;
    const auto add = [&](const char* what, const PaperClaimMeasurement& of,
                         const std::string& value, const std::string& limit) {
      if (!of.limit || of.satisfies_limit()) return;
      text += fmt::format("{}{} {} is {} {}", text.empty() ? "" : ", ", what, value,
                          of.above ? "not above" : "above", limit);
    };
    const auto& [l1, tail] = std::tie(judgement_.l1, judgement_.tail);
    add("L1", l1, l1_distance_text(l1.value), l1_distance_text(l1.limit));
    add("tail", tail, tail_distance_text(tail.value), tail_distance_text(tail.limit));
    return text;
  }

  static constexpr const char* kNoDensity =
      "solves its equations but is no probability density (inadmissible)";

  const results::Run& run_;
  PaperClaimJudgement judgement_;
  std::string missing_reason_;
};

}  // namespace

std::vector<PaperClaimJudgement> judge_claims(const results::Run& run) {
  std::vector<PaperClaimJudgement> all;
  for (const auto& claim : paper_claims())
    all.push_back(PaperClaimJudge(run, claim).make_judgement());
  return all;
}

namespace {

// Trailing zeros, as in "0.02000", would suggest more significant digits than the limit of a claim
// has.
std::string without_trailing_zeros(std::string number) {
  if (number.find('.') == std::string::npos || number.find('e') != std::string::npos) return number;
  number.erase(number.find_last_not_of('0') + 1);
  return number.ends_with('.') ? number.substr(0, number.size() - 1) : number;
}

}  // namespace

std::string l1_distance_text(const std::optional<double>& l1) {
  return l1 ? without_trailing_zeros(report::l1_distance_text(*l1)) : "";
}

std::string tail_distance_text(const std::optional<double>& tail) {
  return tail ? without_trailing_zeros(fmt::format("{:.3f}", *tail)) : "";
}

}  // namespace fpkcheck::paper
