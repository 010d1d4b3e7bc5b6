#include "report/page/first_shown.hpp"

#include <gtest/gtest.h>

#include "made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using Ids = std::set<std::string>;

TEST(FirstShown, AreTheReferencesAndTheClosestClosureOfEachFamily) {
  auto one = tests::whole_case();
  EXPECT_EQ(first_shown(one), (Ids{"epc-gaussian-n6", "fd-kf", "mcs"}));
  tests::solution_of(one, "epc-gaussian-n2").identity.family = "of-another";
  EXPECT_EQ(first_shown(one), (Ids{"epc-gaussian-n2", "epc-gaussian-n6", "fd-kf", "mcs"}));
}

TEST(FirstShown, AreGuestsWhateverTheySolve) {
  auto one = tests::whole_case();
  tests::solution_of(one, "epc-gaussian-n2").identity.method = transform::kGivenInFile;
  EXPECT_TRUE(first_shown(one).contains("epc-gaussian-n2"));
}

TEST(FirstShown, AreAllWhereThatLeavesFewerThanTwo) {
  auto one = tests::whole_case();
  for (auto& solution : one.solutions) {
    if (solution.id() != "mcs") solution.status = transform::Status::failed;
  }
  EXPECT_EQ(first_shown(one).size(), one.solutions.size());
}

}  // namespace
}  // namespace fpkcheck::report
