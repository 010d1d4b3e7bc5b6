#include "report/case_solutions.hpp"

#include <gtest/gtest.h>

#include "page/made_up_page.hpp"

namespace fpkcheck::report {
namespace {

TEST(Families, KeepTheOrderOfTheSolutions) {
  const auto case_result = tests::whole_case();
  const auto all = group_by_family(case_result.solutions);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "epc-gaussian");
  EXPECT_EQ(all[1].name, "fd");
  EXPECT_EQ(all[2].name, "mcs");
  ASSERT_EQ(all[1].solutions.size(), 3u);
  EXPECT_EQ(all[1].solutions[0], case_result.find("fd-white"));
  EXPECT_EQ(all[1].solutions[2], case_result.find("fd-kf"));
}

TEST(Families, GroupASelectionOfSolutions) {
  const auto case_result = tests::whole_case();
  const auto all = group_by_family(std::vector{case_result.find("mcs"), case_result.find("fd-kf")});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "mcs");
  EXPECT_EQ(all[1].solutions.size(), 1u);
}

}  // namespace
}  // namespace fpkcheck::report
