#include "report/verdict/agreement.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../modified_case.hpp"
#include "saved_run.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::set_l1;
using tests::solution_of;

TEST(Agreement, DependsOnBothDistancesToTheReference) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n6", "mcs", 0.0024, 0.0199);
  set_l1(case_result, "epc-gaussian-n2", "mcs", 0.0024, 0.0201);
  set_l1(case_result, "fd-white", "mcs", 0.0201, 0.001);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n6").agreement, Agreement::close);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n2").agreement, Agreement::distant);
  EXPECT_EQ(agreement_entry(case_result, "fd-white").agreement, Agreement::distant);
  EXPECT_EQ(agreement_entry(case_result, "mcs").agreement, Agreement::reference);
  EXPECT_EQ(agreement_entry(case_result, "nobody").agreement, Agreement::absent);
  EXPECT_DOUBLE_EQ(*agreement_entry(case_result, "epc-gaussian-n6").largest_l1(), 0.0199);
}

TEST(Agreement, IsIndistinguishableWithinTheReferenceError) {
  auto case_result =
      made_up_case();  // expected sampling errors of the simulation: 0.0011 and 0.0015
  set_l1(case_result, "fd-kf", "mcs", 0.0010, 0.0014);
  EXPECT_EQ(agreement_entry(case_result, "fd-kf").agreement, Agreement::indistinguishable);
  set_l1(case_result, "fd-kf", "mcs", 0.0010, 0.0016);
  EXPECT_EQ(agreement_entry(case_result, "fd-kf").agreement, Agreement::close);
  set_l1(case_result, "fd-kf", "mcs", 0.0012, 0.0014);
  EXPECT_EQ(agreement_entry(case_result, "fd-kf").agreement, Agreement::close);
}

TEST(Agreement, OfAnInadmissibleSolutionIsNeverReproduced) {
  auto case_result = made_up_case();
  set_l1(case_result, "epc-gaussian-n4", "mcs", 1e-4, 1e-4);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n4").agreement, Agreement::no_density);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n8").agreement, Agreement::no_density);
  EXPECT_FALSE(agreement_entry(case_result, "epc-gaussian-n4").reproduces_reference());
  solution_of(case_result, "epc-gaussian-n4").status = transform::Status::inaccurate;
  EXPECT_TRUE(agreement_entry(case_result, "epc-gaussian-n4").reproduces_reference());
}

TEST(Agreement, IsUnknownWithoutAReference) {
  const auto case_result = tests::case_with_first(4);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n2").agreement, Agreement::no_reference);
  EXPECT_EQ(agreement_entry(case_result, "epc-gaussian-n4").agreement, Agreement::no_density);
}

TEST(AgreementRows, HaveEverySolutionOnceInTheOrderOfTrust) {
  auto first = made_up_case("a"), second = made_up_case("b");
  std::erase_if(first.solutions, [](const auto& s) { return s.id() == "fd-km4"; });
  std::erase_if(second.solutions, [](const auto& s) { return s.id() == "fd-white"; });
  const results::Run run{{}, {first, second}};
  std::vector<std::string> ids;
  for (const auto& row : agreement_rows(run)) ids.push_back(row.identity->id);
  const auto at = [&](const char* id) { return std::ranges::find(ids, id) - ids.begin(); };
  EXPECT_EQ(ids.size(), 8u);
  EXPECT_LT(at("epc-gaussian-n8"), at("fd-km4"));
  EXPECT_LT(at("fd-km4"), at("fd-kf"));
  EXPECT_EQ(ids.back(), "mcs");
  const auto white = agreement_rows(run)[static_cast<std::size_t>(at("fd-white"))];
  EXPECT_EQ(white.case_count(), 1);
  EXPECT_EQ(white.entries[1].agreement, Agreement::absent);
}

TEST(AgreementRows, HaveTheLargestDistanceOverCases) {
  auto first = made_up_case("a"), second = made_up_case("b");
  set_l1(first, "epc-gaussian-n6", "mcs", 0.003, 0.004);
  set_l1(second, "epc-gaussian-n6", "mcs", 0.005, 0.002);
  const results::Run run{{}, {first, second}};
  for (const auto& row : agreement_rows(run)) {
    if (row.identity->id == "epc-gaussian-n6") {
      EXPECT_DOUBLE_EQ(*row.largest_l1_of(&AgreementEntry::y), 0.005);
      EXPECT_DOUBLE_EQ(*row.largest_l1_of(&AgreementEntry::ydot), 0.004);
      EXPECT_DOUBLE_EQ(*row.largest_l1(), 0.005);
    }
    if (row.identity->id == "epc-gaussian-n4") {
      EXPECT_FALSE(row.largest_l1());
    }
  }
}

}  // namespace
}  // namespace fpkcheck::report
