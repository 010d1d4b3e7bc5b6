#include "results/run_assessment.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../report/modified_case.hpp"

namespace fpkcheck::results {
namespace {

using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;

TEST(AgreementRows, HaveEverySolutionOnceInTheOrderOfTrust) {
  auto first = made_up_case("a"), second = made_up_case("b");
  std::erase_if(first.solutions, [](const auto& s) { return s.id() == "fd-km4"; });
  std::erase_if(second.solutions, [](const auto& s) { return s.id() == "fd-white"; });
  first.update_assessment();
  second.update_assessment();
  const results::Run run{{}, {first, second}};
  std::vector<std::string> ids;
  for (const auto& row : assess_run(run).rows) ids.push_back(row.identity->id);
  const auto at = [&](const char* id) { return std::ranges::find(ids, id) - ids.begin(); };
  EXPECT_EQ(ids.size(), 8u);
  EXPECT_LT(at("epc-gaussian-n8"), at("fd-km4"));
  EXPECT_LT(at("fd-km4"), at("fd-kf"));
  EXPECT_EQ(ids.back(), "mcs");
  const auto white = assess_run(run).rows[static_cast<std::size_t>(at("fd-white"))];
  EXPECT_EQ(white.case_count(), 1);
  EXPECT_EQ(white.entries[1].agreement, compare::AgreementWithReference::absent);
}

TEST(AgreementRows, HaveTheLargestDistanceOverCases) {
  auto first = made_up_case("a"), second = made_up_case("b");
  set_l1(first, "epc-gaussian-n6", "mcs", 0.003, 0.004);
  set_l1(second, "epc-gaussian-n6", "mcs", 0.005, 0.002);
  const results::Run run{{}, {first, second}};
  for (const auto& row : assess_run(run).rows) {
    if (row.identity->id == "epc-gaussian-n6") {
      EXPECT_DOUBLE_EQ(*row.largest_l1_distance_of_marginal(&SolutionAgreementInCase::y), 0.005);
      EXPECT_DOUBLE_EQ(*row.largest_l1_distance_of_marginal(&SolutionAgreementInCase::ydot), 0.004);
      EXPECT_DOUBLE_EQ(*row.largest_l1_distance(), 0.005);
    }
    if (row.identity->id == "epc-gaussian-n4") {
      EXPECT_FALSE(row.largest_l1_distance());
    }
  }
}

}  // namespace
}  // namespace fpkcheck::results
