#include "compare/solution_assessment.hpp"

#include <gtest/gtest.h>

#include "../report/modified_case.hpp"
#include "compare/comparison.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using problem::DensityEquation;
using problem::ImpactCondition;
using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;
using transform::Solution;
using transform::Status;

std::vector<Solution> made_up() {
  return tests::made_up_solutions(comparison_bins(tests::paper_case(1)));
}

Solution& find(std::vector<Solution>& solutions, const std::string& id) {
  return *std::ranges::find(solutions, id, &Solution::id);
}

std::string reference_id(const std::vector<Solution>& solutions) {
  return assess_solutions(solutions).reference;
}

TEST(Reference, HasTheSmallestErrorEstimate) {
  auto solutions = made_up();
  EXPECT_EQ(reference_id(solutions), "mcs");  // fd-kf has no error estimate
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  EXPECT_EQ(reference_id(solutions), "fd-kf");  // sampling errors of mcs: 0.0011, 0.0015
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-3};
  EXPECT_EQ(reference_id(solutions), "mcs");
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  find(solutions, "fd-kf").status = Status::inadmissible;
  EXPECT_EQ(reference_id(solutions), "mcs");
}

TEST(Reference, IsTheMoreTrustedWithoutErrorEstimates) {
  auto solutions = made_up();
  find(solutions, "mcs").sampling.reset();
  EXPECT_EQ(reference_id(solutions), "mcs");
}

TEST(Reference, SolvesTheFullProblem) {
  auto solutions = made_up();
  std::erase_if(solutions, [](const Solution& s) { return s.id() == "fd-kf" || s.id() == "mcs"; });
  EXPECT_EQ(reference_id(solutions), "");
  for (auto& s : solutions) {
    s.identity.equation = DensityEquation::kf;
    s.identity.impact = ImpactCondition::delta;
    s.error = {.y_l1 = 1e-9, .ydot_l1 = 1e-9};
  }
  EXPECT_EQ(reference_id(solutions), "");
  find(solutions, "epc-gaussian-n6").identity.impact = ImpactCondition::map;
  EXPECT_EQ(reference_id(solutions), "");
  find(solutions, "fd-km4").identity.impact = ImpactCondition::map;
  EXPECT_EQ(reference_id(solutions), "fd-km4");
}

TEST(Reference, RanksClosuresAndMarksIndistinguishableOnes) {
  auto solutions = made_up();
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  const auto comparison = compare_solutions(comparison_bins(tests::paper_case(1)), solutions);
  const SolutionsAssessment assessment = assess_solutions(solutions, comparison.pairs);
  const auto ranks = assessment.closures_ranked_by_distance();
  ASSERT_EQ(ranks.size(), 2u);  // n4 is inadmissible, n8 has no density
  EXPECT_EQ(ranks[0]->id, "epc-gaussian-n6");
  EXPECT_EQ(ranks[1]->id, "epc-gaussian-n2");
  EXPECT_EQ(ranks[1]->rank, 2);
  EXPECT_EQ(ranks[0]->y, l1_distance_between(comparison.pairs, "fd-kf", "epc-gaussian-n6",
                                             transform::StateVariable::y));
  EXPECT_FALSE(assessment.are_closures_indistinguishable(*ranks[0], *ranks[1]));
  SolutionAssessment near = *ranks[0];
  *near.y += 4.9e-5;  // the error estimates of both marginals sum to 5e-5
  EXPECT_TRUE(assessment.are_closures_indistinguishable(*ranks[0], near));
  *near.y += 0.2e-5;
  EXPECT_FALSE(assessment.are_closures_indistinguishable(*ranks[0], near));
}

const SolutionAssessment& assessed(const results::CaseResult& case_result, const char* id) {
  return *case_result.assessment.find_solution_assessment(id);
}

TEST(Agreement, DependsOnBothDistancesToTheReference) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.0024, 0.0199);
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.0024, 0.0201);
  set_l1(case_result, "fd-white", "mcs", 0.0201, 0.001);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n6").agreement, AgreementWithReference::close);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n2").agreement, AgreementWithReference::distant);
  EXPECT_EQ(assessed(case_result, "fd-white").agreement, AgreementWithReference::distant);
  EXPECT_EQ(assessed(case_result, "mcs").agreement, AgreementWithReference::reference);
  EXPECT_DOUBLE_EQ(*assessed(case_result, "epc-gaussian-n6").largest_l1_distance(), 0.0199);
}

TEST(Agreement, IsIndistinguishableWithinTheReferenceError) {
  auto case_result =
      made_up_case();  // expected sampling errors of the simulation: 0.0011 and 0.0015
  set_l1(case_result, "fd-kf", "mcs", 0.0010, 0.0014);
  EXPECT_EQ(assessed(case_result, "fd-kf").agreement, AgreementWithReference::indistinguishable);
  set_l1(case_result, "fd-kf", "mcs", 0.0010, 0.0016);
  EXPECT_EQ(assessed(case_result, "fd-kf").agreement, AgreementWithReference::close);
  set_l1(case_result, "fd-kf", "mcs", 0.0012, 0.0014);
  EXPECT_EQ(assessed(case_result, "fd-kf").agreement, AgreementWithReference::close);
}

TEST(Agreement, OfAnInadmissibleSolutionIsNeverReproduced) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n4", "mcs", 1e-4, 1e-4);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n4").agreement, AgreementWithReference::no_density);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n8").agreement, AgreementWithReference::no_density);
  EXPECT_FALSE(assessed(case_result, "epc-gaussian-n4").reproduces_reference());
  solution_of(case_result, "epc-gaussian-n4").status = Status::inaccurate;
  case_result.update_assessment();
  EXPECT_TRUE(assessed(case_result, "epc-gaussian-n4").reproduces_reference());
}

TEST(Agreement, IsUnknownWithoutAReference) {
  const auto case_result = tests::case_with_first(4);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n2").agreement,
            AgreementWithReference::no_reference);
  EXPECT_EQ(assessed(case_result, "epc-gaussian-n4").agreement, AgreementWithReference::no_density);
}

TEST(ReferenceConfirmation, IsTheAgreementOfTheSecondSolutionOfTheFullProblem) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-3, .ydot_l1 = 1e-3};
  set_l1(case_result, "fd-kf", "mcs", 1e-4, 1e-4);
  ASSERT_TRUE(case_result.assessment.confirmation);
  const std::string reference = case_result.assessment.reference;
  EXPECT_EQ(case_result.assessment.confirmation->id, reference == "mcs" ? "fd-kf" : "mcs");
  EXPECT_TRUE(case_result.assessment.confirmation->has_agreement);
  set_l1(case_result, "fd-kf", "mcs", 0.5, 0.5);
  EXPECT_FALSE(case_result.assessment.confirmation->has_agreement);
  solution_of(case_result, "fd-kf").status = Status::failed;
  case_result.update_assessment();
  EXPECT_FALSE(case_result.assessment.confirmation);
}

}  // namespace
}  // namespace fpkcheck::compare
