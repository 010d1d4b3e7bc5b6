#include "report/figure/curve_selection.hpp"

#include <gtest/gtest.h>

#include "../page/made_up_page.hpp"
#include "base/input_error.hpp"
#include "modified_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;
using Ids = std::set<std::string>;

TEST(CurveSelection, IsTheReferenceOtherSolutionsTheClosestClosuresAndNoMoreThanSix) {
  auto case_result = made_up_case();
  const auto prototype = solution_of(case_result, "epc-gaussian-n2");
  const auto curves = case_result.curves;
  for (int order = 20; order < 40; order += 2) {
    auto more = prototype;
    more.identity = tests::closure_identity("gaussian", order);
    for (auto curve : curves) {
      if (curve.solution != prototype.id()) continue;
      curve.solution = more.id();
      case_result.curves.push_back(curve);
    }
    case_result.solutions.insert(case_result.solutions.begin(), more);
  }
  const auto ids = select_solutions_to_draw(case_result);
  EXPECT_EQ(ids.size(), kMaxDefaultCurves);
  for (const char* id : {"mcs", "fd-kf", "epc-gaussian-n2", "fd-km4"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(CurveSelection, AlwaysContainsExternalDensities) {
  auto case_result = made_up_case();
  for (auto& solution : case_result.solutions) solution.identity.method = transform::kExternalFile;
  EXPECT_EQ(select_solutions_to_draw(case_result).size(),
            select_solutions_to_draw(case_result, {"all"}).size());
}

TEST(CurveSelection, SelectsByIdFamilyOrSolver) {
  const auto case_result = made_up_case();
  EXPECT_EQ(select_solutions_to_draw(case_result, {"mcs"}), Ids{"mcs"});
  const auto closures = select_solutions_to_draw(case_result, {"epc"});
  EXPECT_TRUE(closures.contains("epc-gaussian-n2") && closures.contains("epc-gaussian-n4"));
  EXPECT_EQ(select_solutions_to_draw(case_result, {"epc-gaussian"}), closures);
  EXPECT_FALSE(closures.contains("mcs"));
  EXPECT_TRUE(select_solutions_to_draw(case_result, {"nothing"}).empty());
}

TEST(CurveSelection, RejectsAnUnknownName) {
  std::vector<transform::SolutionIdentity> available;
  for (const auto& solution : made_up_case().solutions) available.push_back(solution.identity);
  EXPECT_NO_THROW(require_requested_curves_exist({"all", "mcs", "epc", "epc-gaussian"}, available));
  try {
    require_requested_curves_exist({"mcs", "fd-kv"}, available);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--curves: 'fd-kv' matches no solution"))
        << error.what();
  }
}

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
  case_result.update_assessment();
  EXPECT_EQ(initially_visible_solutions(case_result).size(), case_result.solutions.size());
}

}  // namespace
}  // namespace fpkcheck::report
