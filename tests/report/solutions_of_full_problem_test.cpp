#include "report/case_solutions.hpp"

#include <gtest/gtest.h>

#include "modified_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;

std::vector<std::string> ids(const results::CaseResult& case_result) {
  std::vector<std::string> all;
  for (const auto* solution : solutions_of_full_problem(case_result)) all.push_back(solution->id());
  return all;
}

TEST(References, AreTheFullProblemSolutionsReferenceFirst) {
  auto case_result = made_up_case();
  EXPECT_EQ(ids(case_result),
            (std::vector<std::string>{"mcs", "fd-kf"}));  // fd-kf has no error estimate
  solution_of(case_result, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  case_result.update_assessment();
  EXPECT_EQ(ids(case_result), (std::vector<std::string>{"fd-kf", "mcs"}));
  solution_of(case_result, "fd-kf").status = transform::Status::failed;
  case_result.update_assessment();
  EXPECT_EQ(ids(case_result), (std::vector<std::string>{"mcs"}));
  solution_of(case_result, "mcs").status = transform::Status::failed;
  case_result.update_assessment();
  EXPECT_TRUE(solutions_of_full_problem(case_result).empty());
}

TEST(ReferenceText, StatesTheReferenceAndItsErrorEstimate) {
  auto case_result = made_up_case();
  solution_of(case_result, "fd-kf").error = {.y_l1 = 2e-5, .ydot_l1 = 3e-5};
  case_result.update_assessment();
  EXPECT_EQ(reference_description_text(case_result),
            "Reference: fd-kf, the solution with the smallest error estimate (L1 2e-05 in p(y), "
            "3e-05 in p(y')).");
  EXPECT_NE(reference_description_text(tests::case_with_first(4)).find("no reference"),
            std::string::npos);
}

}  // namespace
}  // namespace fpkcheck::report
