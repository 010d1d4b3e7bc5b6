#include "workflows/paper/judge_claims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "judged_run.hpp"
#include "workflows/paper/claim_criteria.hpp"

namespace fpkcheck::paper {
namespace {

using tests::budget_row;
using tests::case_in;
using tests::closure;
using tests::find_judgement;
using tests::run_with_distances;
using transform::StateVariable;
using transform::Status;

constexpr const char* kAgrees = "n=6 agrees with MCS in p(y)";
constexpr const char* kDiffers = "n=2 differs from MCS in p(y')";
constexpr const char* kBetter = "n=6 is better than n=2 in p(y')";
constexpr const char* kNotFound = "n=8 is not found by Newton's method";
constexpr double kJustAbove = 1 + 1e-9;

PaperClaimOutcome outcome(const results::Run& run, int number, const char* claim_text) {
  return find_judgement(run, number, claim_text).outcome;
}

TEST(Judge, AgreementNeedsBothNumbersWithinTheirLimits) {
  EXPECT_EQ(
      outcome(run_with_distances(kMaxL1OfClaimedAgreement, kMaxTailDistanceOfClaimedAgreement), 1,
              kAgrees),
      PaperClaimOutcome::established);
  EXPECT_EQ(outcome(run_with_distances(kMaxL1OfClaimedAgreement * kJustAbove, 0.1), 1, kAgrees),
            PaperClaimOutcome::not_established);
  const auto tail = find_judgement(run_with_distances(0.01, 0.21), 1, kAgrees);
  EXPECT_EQ(tail.outcome, PaperClaimOutcome::not_established);
  EXPECT_EQ(tail.note, "tail 0.21 is above 0.2");
  EXPECT_EQ(tail.l1.value, 0.01);
  EXPECT_EQ(tail.tail.limit, kMaxTailDistanceOfClaimedAgreement);
}

TEST(Judge, OneNumberAboveItsLimitIsADifference) {
  EXPECT_EQ(outcome(run_with_distances(0.03, 0.1), 1, kDiffers), PaperClaimOutcome::established);
  EXPECT_EQ(outcome(run_with_distances(0.01, 0.3), 1, kDiffers), PaperClaimOutcome::established);
  const auto neither = find_judgement(run_with_distances(0.01, 0.1), 1, kDiffers);
  EXPECT_EQ(neither.outcome, PaperClaimOutcome::not_established);
  EXPECT_EQ(neither.note, "L1 0.01 is not above 0.02, tail 0.1 is not above 0.2");
}

TEST(Judge, ForClaimsOnTheTailTheTailAloneDecides) {
  auto run = run_with_distances(0.03, 0.1);
  EXPECT_EQ(outcome(run, 4, "n=6 agrees in the tail of p(y)"), PaperClaimOutcome::established);
  EXPECT_EQ(outcome(run, 1, "n=4 differs in the tail of p(y)"), PaperClaimOutcome::not_established);
  run = run_with_distances(0.01, 0.3);
  EXPECT_EQ(outcome(run, 4, "n=6 agrees in the tail of p(y)"), PaperClaimOutcome::not_established);
  EXPECT_EQ(outcome(run, 1, "n=4 differs in the tail of p(y)"), PaperClaimOutcome::established);
}

TEST(Judge, BetterMeansBetterByMoreThanTheReferenceError) {
  auto run = run_with_distances();
  auto& own = budget_row(run, 3, 6, StateVariable::ydot);
  const auto& rival = budget_row(run, 3, 2, StateVariable::ydot);
  const double open = 0.0015;  // error of the simulation in p(y')
  own.total_tail = rival.total_tail / 2;
  own.total = rival.total - 1.1 * open;
  EXPECT_EQ(outcome(run, 3, kBetter), PaperClaimOutcome::established);
  own.total = rival.total - 0.9 * open;
  EXPECT_EQ(outcome(run, 3, kBetter), PaperClaimOutcome::not_established);
  own.total = rival.total / 2;
  own.total_tail = rival.total_tail * kJustAbove;
  EXPECT_EQ(outcome(run, 3, kBetter), PaperClaimOutcome::not_established);
  // Finite volumes and the simulation differ by more than the two closures.
  own.total_tail = rival.total_tail - 0.01;
  own.parts.back().approximations = {compare::ModelApproximation::discretisation};
  own.parts.back().tail = 0.02;
  EXPECT_EQ(outcome(run, 3, kBetter), PaperClaimOutcome::not_established);
  own.parts.back().tail = 0.005;
  EXPECT_EQ(outcome(run, 3, kBetter), PaperClaimOutcome::established);
}

TEST(Judge, BetterInOnePanelIsDecidedByItsNumberAlone) {
  auto run = run_with_distances();
  budget_row(run, 4, 6, StateVariable::y).total = 0.001;
  budget_row(run, 4, 6, StateVariable::y).total_tail = 5;
  EXPECT_EQ(outcome(run, 4, "n=6 is better than n=4 in p(y), L1"), PaperClaimOutcome::established);
  budget_row(run, 4, 6, StateVariable::ydot).total = 0.5;
  budget_row(run, 4, 6, StateVariable::ydot).total_tail = 0.01;
  EXPECT_EQ(outcome(run, 4, "n=6 is better than n=4 in p(y'), tail"),
            PaperClaimOutcome::established);
}

TEST(Judge, AgreementOfAnInadmissibleClosureIsQualified) {
  const auto good = find_judgement(run_with_distances(), 4, "n=4 agrees with MCS in p(y')");
  EXPECT_EQ(good.outcome, PaperClaimOutcome::qualified);
  EXPECT_EQ(good.note, "n=4 solves its equations but is no probability density (inadmissible)");
  EXPECT_EQ(good.status, Status::inadmissible);
  EXPECT_NE(good.reason.find("the leading form"), std::string::npos);
  const auto bad = find_judgement(run_with_distances(0.03), 4, "n=4 agrees with MCS in p(y')");
  EXPECT_EQ(bad.outcome, PaperClaimOutcome::not_established);
  EXPECT_EQ(bad.note,
            "L1 0.03 is above 0.02; and n=4 solves its equations but is no probability density "
            "(inadmissible)");
  // `differs` needs no admissible density.
  EXPECT_EQ(outcome(run_with_distances(0.03), 1, "n=4 differs from MCS in p(y')"),
            PaperClaimOutcome::established);
}

TEST(Judge, OfAllCasesTheWorstDecides) {
  auto run = run_with_distances();
  EXPECT_EQ(outcome(run, 0, kAgrees), PaperClaimOutcome::established);
  budget_row(run, 3, 6, StateVariable::y).total = 0.025;
  budget_row(run, 3, 6, StateVariable::ydot).total = 0.5;
  const auto all = find_judgement(run, 0, kAgrees);
  EXPECT_EQ(all.outcome, PaperClaimOutcome::not_established);
  EXPECT_EQ(all.l1.value, 0.025);
  closure(run, 2, 6).status = Status::inadmissible;
  EXPECT_EQ(find_judgement(run, 0, kAgrees).status, Status::inadmissible);
}

TEST(Judge, LessGaussianIsFurtherFromTheGaussianThanInCase1) {
  constexpr const char* kLess = "p(y) is less Gaussian than in case 1";
  auto run = run_with_distances();
  EXPECT_EQ(outcome(run, 2, kLess), PaperClaimOutcome::not_established);
  budget_row(run, 2, 2, StateVariable::y).total = 0.02;
  EXPECT_EQ(outcome(run, 2, kLess), PaperClaimOutcome::established);
  budget_row(run, 1, 2, StateVariable::y).total = 0.03;
  EXPECT_EQ(outcome(run, 2, kLess), PaperClaimOutcome::not_established);
}

TEST(Judge, OrderTwoIsComparedWithEquivalentLinearisation) {
  constexpr const char* kSame = "n=2 is equivalent linearisation";
  const auto off = find_judgement(run_with_distances(), 0, kSame);
  EXPECT_EQ(off.outcome,
            PaperClaimOutcome::not_established);  // the made-up solution is another Gaussian
  EXPECT_GT(off.l1.value.value(), kMaxL1BetweenEqualGaussians);
  auto run = run_with_distances();
  std::erase_if(case_in(run, 2).curves, [](const results::DensityCurve& curve) {
    return curve.solution == paper_closure_id(2) && curve.variable == StateVariable::ydot;
  });
  EXPECT_EQ(outcome(run, 0, kSame), PaperClaimOutcome::unjudged);
}

TEST(Judge, OrderEightIsNotFoundUnlessPlainNewtonStepsFindARoot) {
  auto run = run_with_distances();
  const auto none = find_judgement(run, 1, kNotFound);
  EXPECT_EQ(none.outcome, PaperClaimOutcome::established);
  EXPECT_NE(none.reason.find("Newton steps"), std::string::npos);

  auto& eighth = closure(run, 1, 8);
  eighth.status = Status::inadmissible;
  eighth.metrics = transform::SolverMetricsBuilder()
                       .add_diagnostic_metric("plain_newton_converges", true)
                       .take_metrics();
  const auto found = find_judgement(run, 1, kNotFound);
  EXPECT_EQ(found.outcome, PaperClaimOutcome::not_established);
  EXPECT_EQ(found.note,
            "plain Newton steps from equivalent linearisation find a root, which solves its "
            "equations but is no probability density (inadmissible)");

  eighth.metrics = transform::SolverMetricsBuilder()
                       .add_diagnostic_metric("plain_newton_converges", false)
                       .take_metrics();
  eighth.status = Status::ok;
  const auto otherwise = find_judgement(run, 1, kNotFound);
  EXPECT_EQ(otherwise.outcome, PaperClaimOutcome::established);
  EXPECT_EQ(otherwise.note, "plain Newton steps find no root, but other methods find a root");
}

TEST(Judge, ClaimsWithoutNumbersAreUnjudgedWithAReason) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::pair<std::function<void(results::Run&)>, std::string>> losses{
      {[](auto& run) {
         std::erase_if(case_in(run, 1).solutions,
                       [](auto& one) { return one.id() == paper_closure_id(6); });
       },
       "case1 has no epc-gaussian-n6"},
      {[](auto& run) { closure(run, 1, 6).status = Status::failed; },
       "epc-gaussian-n6 failed in case1"},
      {[](auto& run) { run.cases.erase(run.cases.begin()); }, "the run has no case1"},
      {[](auto& run) { case_in(run, 1).budget.clear(); }, "case1 has no reference solution"},
      {[](auto& run) { case_in(run, 1).solutions.back().sampling = {.y = 0.1, .ydot = 0.1}; },
       "the reference of case1 has an error of up to L1 0.1: simulate longer"},
      {[=](auto& run) { budget_row(run, 1, 6, StateVariable::y).total_tail = nan; },
       "no bin of the tail is positive and resolved in all solutions"}};
  for (const auto& [lose, why] : losses) {
    auto run = run_with_distances();
    lose(run);
    for (auto& case_result : run.cases) case_result.update_assessment();
    const auto one = find_judgement(run, 1, kAgrees);
    EXPECT_EQ(one.outcome, PaperClaimOutcome::unjudged) << why;
    EXPECT_EQ(one.note, why);
  }
}

}  // namespace
}  // namespace fpkcheck::paper
