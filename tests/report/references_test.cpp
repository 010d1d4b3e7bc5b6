#include "report/references.hpp"

#include <gtest/gtest.h>

#include "changed_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;

std::vector<std::string> ids(const results::Case& one) {
  std::vector<std::string> all;
  for (const auto* solution : references(one)) all.push_back(solution->id());
  return all;
}

TEST(References, AreTheSolutionsOfTheProblemItselfTheReferenceFirst) {
  auto one = made_up_case();
  EXPECT_EQ(ids(one), (std::vector<std::string>{"mcs", "fd-kf"}));  // fd-kf has no error estimate
  solution_of(one, "fd-kf").error = {.y_l1 = 1e-5, .ydot_l1 = 1e-5};
  EXPECT_EQ(ids(one), (std::vector<std::string>{"fd-kf", "mcs"}));
  solution_of(one, "fd-kf").status = transform::Status::failed;
  EXPECT_EQ(ids(one), (std::vector<std::string>{"mcs"}));
  solution_of(one, "mcs").status = transform::Status::failed;
  EXPECT_TRUE(references(one).empty());
}

}  // namespace
}  // namespace fpkcheck::report
