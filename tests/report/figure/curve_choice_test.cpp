#include "report/figure/curve_choice.hpp"

#include <gtest/gtest.h>

#include "base/input_error.hpp"
#include "changed_case.hpp"

namespace fpkcheck::report {
namespace {

using tests::made_up_case;
using tests::solution_of;
using Ids = std::set<std::string>;

TEST(CurveChoice, IsTheReferenceOtherSolutionsTheClosestClosuresAndNoMoreThanSix) {
  auto one = made_up_case();
  const auto prototype = solution_of(one, "epc-gaussian-n2");
  const auto curves = one.curves;
  for (int order = 20; order < 40; order += 2) {
    auto more = prototype;
    more.identity = tests::closure_identity("gaussian", order);
    for (auto curve : curves) {
      if (curve.solution != prototype.id()) continue;
      curve.solution = more.id();
      one.curves.push_back(curve);
    }
    one.solutions.insert(one.solutions.begin(), more);
  }
  const auto ids = chosen_curves(one);
  EXPECT_EQ(ids.size(), kMostCurves);
  for (const char* id : {"mcs", "fd-kf", "epc-gaussian-n2", "fd-km4"}) {
    EXPECT_TRUE(ids.contains(id)) << id;
  }
}

TEST(CurveChoice, AlwaysHasWhatCameFromFiles) {
  auto one = made_up_case();
  for (auto& solution : one.solutions) solution.identity.method = transform::kGivenInFile;
  EXPECT_EQ(chosen_curves(one).size(), chosen_curves(one, {"all"}).size());
}

TEST(CurveChoice, IsWhatIsWantedByIdFamilyOrSolver) {
  const auto one = made_up_case();
  EXPECT_EQ(chosen_curves(one, {"mcs"}), Ids{"mcs"});
  const auto closures = chosen_curves(one, {"epc"});
  EXPECT_TRUE(closures.contains("epc-gaussian-n2") && closures.contains("epc-gaussian-n4"));
  EXPECT_EQ(chosen_curves(one, {"epc-gaussian"}), closures);
  EXPECT_FALSE(closures.contains("mcs"));
  EXPECT_TRUE(chosen_curves(one, {"nothing"}).empty());
}

TEST(CurveChoice, OfWhatIsNotThereIsRefusedByName) {
  std::vector<transform::Identity> there;
  for (const auto& solution : made_up_case().solutions) there.push_back(solution.identity);
  EXPECT_NO_THROW(require_curves({"all", "mcs", "epc", "epc-gaussian"}, there));
  try {
    require_curves({"mcs", "fd-kv"}, there);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--curves: 'fd-kv' matches no solution"))
        << error.what();
  }
}

}  // namespace
}  // namespace fpkcheck::report
