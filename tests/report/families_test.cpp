#include "report/families.hpp"

#include <gtest/gtest.h>

#include "page/made_up_page.hpp"

namespace fpkcheck::report {
namespace {

TEST(Families, KeepTheOrderOfTheSolutions) {
  const auto one = tests::whole_case();
  const auto all = families(one.solutions);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].name, "epc-gaussian");
  EXPECT_EQ(all[1].name, "fd");
  EXPECT_EQ(all[2].name, "mcs");
  ASSERT_EQ(all[1].solutions.size(), 3u);
  EXPECT_EQ(all[1].solutions[0], one.find("fd-white"));
  EXPECT_EQ(all[1].solutions[2], one.find("fd-kf"));
}

TEST(Families, AreOfSomeSolutionsToo) {
  const auto one = tests::whole_case();
  const auto all = families(std::vector{one.find("mcs"), one.find("fd-kf")});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].name, "mcs");
  EXPECT_EQ(all[1].solutions.size(), 1u);
}

}  // namespace
}  // namespace fpkcheck::report
