#include "compare/methods.hpp"

#include <gtest/gtest.h>

#include "paper_cases.hpp"
#include "problem/input_error.hpp"

namespace fpkcheck::compare {
namespace {

std::vector<std::string> ids(const std::string& list) {
  std::vector<std::string> result;
  for (const auto& method : select_methods(list, {})) result.push_back(method.id);
  return result;
}

using Ids = std::vector<std::string>;

TEST(Methods, FamiliesStandForTheirMembersByIncreasingTrust) {
  EXPECT_EQ(ids("mcs,fd,epc"),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n4", "epc-gaussian-n6", "epc-gaussian-n8",
                 "epc-moment-n4", "epc-moment-n8", "epc-moment-n12", "epc-polar-n4", "epc-polar-n6",
                 "epc-polar-n8", "fd-white", "fd-km4-delta", "fd-km4", "fd-kf", "mcs"}));
}

TEST(Methods, ItemsAreTakenOnceAndOrdersByNumber) {
  EXPECT_EQ(ids("epc-gaussian-n12,fd-kf,epc-gaussian-n2,fd-kf,fd-km4,epc-gaussian-n02"),
            (Ids{"epc-gaussian-n2", "epc-gaussian-n12", "fd-km4", "fd-kf"}));
}

TEST(Methods, AFormulationStandsForItsOrdersAndVariantsHaveNames) {
  EXPECT_EQ(ids("epc-moment"), (Ids{"epc-moment-n4", "epc-moment-n8", "epc-moment-n12"}));
  EXPECT_EQ(
      ids("epc-moment-cut-n6,epc-gaussian-white-n4,epc-moment-white-n6,epc-moment-n6"),
      (Ids{"epc-gaussian-white-n4", "epc-moment-cut-n6", "epc-moment-n6", "epc-moment-white-n6"}));
}

TEST(Methods, WhatIsNoMethodIsRefusedByName) {
  for (const std::string bad :
       {"", "fdm", "fd-kf2", "epc-gaussian-n", "epc-gaussian-n6x", "epc,,mcs", "mcs2"}) {
    EXPECT_THROW(ids(bad), InputError) << bad;
  }
  EXPECT_THROW(ids("epc-gaussian-n7"), InputError);    // odd
  EXPECT_THROW(ids("epc-gaussian-n400"), InputError);  // huge
  EXPECT_THROW(ids("epc-moment-km4-n6"), InputError);  // no process belongs to it
}

TEST(Methods, SolutionsCarryTheIdThatTheMethodPromised) {
  const auto problem = tests::paper_case(1);
  const auto axes = comparison_axes(problem);
  mcs::Options brief;
  brief.time = 5000;
  for (const auto& method :
       select_methods("epc-gaussian-n2,epc-gaussian-white-n4,epc-moment-n4,epc-moment-cut-n2,"
                      "fd-white,mcs",
                      brief)) {
    const Entry entry = method.solve(problem, axes, [](double, const std::string&) {});
    EXPECT_EQ(entry.solution.id, method.id);
    EXPECT_TRUE(entry.solution.density.has_value()) << method.id;
    EXPECT_TRUE(entry.details.is_object());
    EXPECT_TRUE(entry.options.is_object());
  }
}

TEST(Methods, SimulationCountsOnTheComparisonAxes) {
  const auto problem = tests::paper_case(1);
  const auto axes = comparison_axes(problem);
  mcs::Options brief;
  brief.time = 5000;
  const Entry entry = mcs_method(brief).solve(problem, axes, {});
  const auto m = marginal(entry.solution, transform::Variable::y, axes.y_edges);
  EXPECT_FALSE(m.lower.empty());  // its own estimate, with intervals
}

}  // namespace
}  // namespace fpkcheck::compare
