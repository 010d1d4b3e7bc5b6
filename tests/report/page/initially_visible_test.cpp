#include "report/page/initially_visible_solutions.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using Ids = std::set<std::string>;

TEST(InitiallyVisible, AreTheReferencesAndTheClosestClosureOfEachFamily) {
  auto case_result = tests::whole_case();
  EXPECT_EQ(initially_visible_solutions(case_result), (Ids{"epc-gaussian-n6", "fd-kf", "mcs"}));
  tests::solution_of(case_result, "epc-gaussian-n2").identity.family = "of-another";
  EXPECT_EQ(initially_visible_solutions(case_result),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n6", "fd-kf", "mcs"}));
}

TEST(InitiallyVisible, IncludeExternalDensities) {
  auto case_result = tests::whole_case();
  tests::solution_of(case_result, "epc-gaussian-n2").identity.method = transform::kExternalFile;
  EXPECT_TRUE(initially_visible_solutions(case_result).contains("epc-gaussian-n2"));
}

TEST(InitiallyVisible, AreAllWhereThatLeavesFewerThanTwo) {
  auto case_result = tests::whole_case();
  for (auto& solution : case_result.solutions) {
    if (solution.id() != "mcs") solution.status = transform::Status::failed;
  }
  EXPECT_EQ(initially_visible_solutions(case_result).size(), case_result.solutions.size());
}

}  // namespace
}  // namespace fpkcheck::report
