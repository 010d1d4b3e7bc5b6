#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <string>

#include "epc/solve.hpp"
#include "judged_run.hpp"
#include "methods/builtin_solvers.hpp"
#include "methods/run_cases.hpp"
#include "paper_cases.hpp"

/// The paper's cases, solved once for all tests of this file.
namespace fpkcheck::paper {
namespace {

// A density within L1 2e-4 of finite volumes and of the simulation (docs/results.md), in place of
// both: they take longer.
std::vector<transform::Solution> quick_references(const problem::Problem& problem) {
  auto solution =
      epc::solve_closure(problem, {.order = 6, .formulation = epc::Formulation::polar}).solution;
  solution.error = transform::ErrorEstimate{.y_l1 = 2e-4, .ydot_l1 = 2e-4, .moments = {}};
  using problem::DensityEquation;
  using problem::ImpactCondition;
  auto equation = solution;
  equation.identity = tests::identity("fd-kf", "fd", DensityEquation::kf, ImpactCondition::map);
  solution.identity = tests::identity("mcs", "mcs", DensityEquation::kf, ImpactCondition::exact);
  return {std::move(equation), std::move(solution)};
}

const std::vector<PaperClaimJudgement>& judgements() {
  static const auto all = [] {
    results::Run run{results::current_program("fpkcheck paper"), {}};
    for (int number = 1; number <= 4; ++number) {
      auto problem = tests::paper_case(number);
      problem.name = paper_case_name(number);
      const auto axes = compare::comparison_bins(problem);
      std::vector<transform::Solution> solutions;
      for (const int order : {2, 4, 6, 8}) {
        // Without `accuracy` no error estimate is computed: the claims do not need it.
        const auto method = methods::builtin_registry().find_method_by_id(
            paper_closure_id(order), {{"accuracy", base::Value()}});
        solutions.push_back(methods::solve_with_method(*method, problem, {axes, {}}));
      }
      std::ranges::move(quick_references(problem), std::back_inserter(solutions));
      run.cases.push_back(results::make_case_result(problem, axes, std::move(solutions)));
    }
    return judge_claims(run);
  }();
  return all;
}

std::map<PaperClaimOutcome, int> counts() {
  std::map<PaperClaimOutcome, int> found;
  for (const auto& one : judgements()) ++found[one.outcome];
  return found;
}

TEST(ThePaper, IsJudgedInEveryClaim) {
  const auto found = counts();
  EXPECT_FALSE(found.contains(PaperClaimOutcome::unjudged));
  EXPECT_EQ(found.at(PaperClaimOutcome::established), 35);
  EXPECT_EQ(found.at(PaperClaimOutcome::qualified), 3);
  EXPECT_EQ(found.at(PaperClaimOutcome::not_established), 6);
}

TEST(ThePaper, ClaimsOnVelocityAndOrdersFourAndEightOfCase4Fail) {
  for (const auto& one : judgements()) {
    if (one.outcome != PaperClaimOutcome::not_established) continue;
    const bool less_gaussian_velocity =
        one.claim.relation == PaperClaimRelation::further_than_in_case_1 &&
        one.claim.variables.front() == transform::StateVariable::ydot;
    const bool of_case_4 =
        one.claim.cases == std::vector<int>{4} && (one.claim.order == 4 || one.claim.order == 8);
    EXPECT_TRUE(less_gaussian_velocity || of_case_4) << claim_text(one.claim);
  }
}

TEST(ThePaper, ClaimsThatOrderSixAgreesAreEstablished) {
  for (const auto& one : judgements()) {
    if (one.claim.order != 6) continue;
    EXPECT_EQ(one.outcome, PaperClaimOutcome::established)
        << claim_text(one.claim) << ": " << one.note;
  }
}

}  // namespace
}  // namespace fpkcheck::paper
