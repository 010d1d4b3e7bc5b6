#include "compare/reference.hpp"

#include <gtest/gtest.h>

#include "compare/comparison.hpp"
#include "made_up_solutions.hpp"

namespace fpkcheck::compare {
namespace {

using problem::Equation;
using problem::Impact;
using transform::Solution;
using transform::Status;

std::vector<Solution> made_up() {
  return tests::made_up_solutions(comparison_axes(tests::paper_case(1)));
}

Solution& find(std::vector<Solution>& solutions, const std::string& id) {
  return *std::ranges::find(solutions, id, &Solution::id);
}

std::string reference_id(const std::vector<Solution>& solutions) {
  const Solution* chosen = select_reference(solutions);
  return chosen == nullptr ? "none" : chosen->id();
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
  EXPECT_EQ(reference_id(solutions), "none");
  EXPECT_NE(reference_text(solutions).find("no reference"), std::string::npos);
  for (auto& s : solutions) {
    s.identity.equation = Equation::kf;
    s.identity.impact = Impact::delta;
    s.error = {.y_l1 = 1e-9, .ydot_l1 = 1e-9};
  }
  EXPECT_EQ(reference_id(solutions), "none");
  find(solutions, "epc-gaussian-n6").identity.impact = Impact::map;
  EXPECT_EQ(reference_id(solutions), "none");
  find(solutions, "fd-km4").identity.impact = Impact::map;
  EXPECT_EQ(reference_id(solutions), "fd-km4");
}

TEST(Reference, RanksClosuresAndMarksIndistinguishableOnes) {
  auto solutions = made_up();
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  const auto comparison = compare_solutions(comparison_axes(tests::paper_case(1)), solutions);
  const auto ranks = closures_by_reference_distance(solutions, comparison.pairs);
  ASSERT_EQ(ranks.size(), 2u);  // n4 is inadmissible, n8 has no density
  EXPECT_EQ(ranks[0].solution->id(), "epc-gaussian-n6");
  EXPECT_EQ(ranks[1].solution->id(), "epc-gaussian-n2");
  EXPECT_EQ(ranks[0].y, l1_distance_between(comparison.pairs, "fd-kf", "epc-gaussian-n6",
                                            transform::Variable::y));
  const Solution& measure = *select_reference(solutions);
  EXPECT_FALSE(are_indistinguishable(ranks[0], ranks[1], measure));
  ReferenceDistance near = ranks[0];
  near.y += 4.9e-5;  // the error estimates of both marginals sum to 5e-5
  EXPECT_TRUE(are_indistinguishable(ranks[0], near, measure));
  near.y += 0.2e-5;
  EXPECT_FALSE(are_indistinguishable(ranks[0], near, measure));
}

TEST(Reference, IsStatedInWords) {
  auto solutions = made_up();
  find(solutions, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  EXPECT_EQ(reference_text(solutions),
            "Reference: fd-kf, the solution with the smallest error estimate (L1 2e-05 in p(y), "
            "3e-05 in p(y')).");
}

}  // namespace
}  // namespace fpkcheck::compare
