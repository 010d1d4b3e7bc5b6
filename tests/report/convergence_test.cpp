#include "report/convergence_over_order.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "external_family.hpp"
#include "modified_case.hpp"
#include "page/made_up_page.hpp"

namespace fpkcheck::report {
namespace {

using transform::Variable;

TEST(ConvergenceOverOrder, IsOfClosuresByOrder) {
  const auto case_result = tests::whole_case();
  const auto found = convergence_over_order(case_result, Variable::y);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->reference->id(), "fd-kf");
  ASSERT_EQ(found->families.size(), 1u);
  EXPECT_EQ(found->families[0].name, "epc-gaussian");
  EXPECT_EQ(found->families[0].solutions.size(), 3u);
  EXPECT_EQ(found->order_range(), std::pair(2, 6));
  EXPECT_EQ(found->l1(*case_result.find("mcs")), *case_result.l1("mcs", "fd-kf", Variable::y));
  ASSERT_EQ(found->uncertainty_lines.size(), 2u);
  EXPECT_EQ(found->uncertainty_lines[1].l1, 2e-5);
}

TEST(ConvergenceOverOrder, SortsFamiliesOfExternalDensitiesByOrder) {
  const auto case_result = tests::case_with_external_family({6, 2, 10});
  const auto found = convergence_over_order(case_result, Variable::y);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->families.size(), 2u);
  std::vector<std::string> ids;
  for (const auto* member : found->families[0].solutions) ids.push_back(member->id());
  EXPECT_EQ(found->families[0].name, "chi");
  EXPECT_EQ(ids, (std::vector<std::string>{"chi-n2", "chi-n6", "chi-n10"}));
  EXPECT_TRUE(found->external_densities.empty());
  EXPECT_EQ(found->order_range(), std::pair(2, 10));
}

TEST(ConvergenceOverOrder, NeedsAReferenceAndAFamilyOfTwoOrders) {
  auto case_result = tests::whole_case();
  for (const char* id : {"epc-gaussian-n2", "epc-gaussian-n4"}) {
    tests::solution_of(case_result, id).identity.family = id;
  }
  EXPECT_FALSE(convergence_over_order(case_result, Variable::y));
  case_result = tests::whole_case();
  for (const char* id : {"fd-kf", "mcs"}) {
    tests::solution_of(case_result, id).status = transform::Status::failed;
    case_result.assess();
  }
  EXPECT_FALSE(convergence_over_order(case_result, Variable::ydot));
}

}  // namespace
}  // namespace fpkcheck::report
